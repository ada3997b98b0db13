finemote frobnicate --help
finemote --format json frobnicat
finemote board frob
finemote tree --bogus --help
