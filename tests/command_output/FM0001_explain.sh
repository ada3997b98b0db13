for code in FM3012 fm3012 3012 12 FM9999 port; do finemote explain $code | head -n 1; done
