cp -r "$cases"/hull/. .
finemote lint robot.urdf --allow FM3152 --allow FM3153 --allow FM3156 --allow FM3163 --allow FM3164 --allow FM3167
finemote -q lint robot.urdf --allow FM3152 --allow FM3153 --allow FM3156 --allow FM3163 --allow FM3164 --allow FM3165 --allow FM3167
