finemote generate robto.urdf -o out
