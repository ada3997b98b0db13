# The robot's own board is the same as none: its timing file counts, as far as it is fresh.
timed_button '[]' null
finemote analyze r.urdf --board robomaster_type_c >table
