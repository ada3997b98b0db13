finemote --data-dir nowhere board show
