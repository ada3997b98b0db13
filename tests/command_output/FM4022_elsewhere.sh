timed_button '[]' null
finemote analyze r.urdf >table
