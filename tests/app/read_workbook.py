# SPDX-License-Identifier: MIT
# Prints a sheet of a workbook as pandas sees it: a line a row, cells between bars, numbers with all their digits.
import sys

import pandas

table = pandas.read_excel(sys.argv[1], sheet_name=sys.argv[2], engine="openpyxl")
print("|".join(table.columns))
for row in table.itertuples(index=False):
    print("|".join("" if pandas.isna(cell) else repr(cell) if isinstance(cell, float) else str(cell) for cell in row))
