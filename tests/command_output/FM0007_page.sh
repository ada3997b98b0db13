# a file of finemote's own that is missing is said, not printed as nothing
cp -rL "$(dirname "$(type -P finemote)")/share" share
rm share/schemas/finemote.xsd
finemote schema xsd --data-dir share
