timed_button '["rate:=2"]' null
finemote -W error analyze r.urdf >table
