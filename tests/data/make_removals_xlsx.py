# Writes removals.xlsx: the removal log of docs/examples/fit as a workbook of a shop, with a title page before it and a
# sheet of stops behind. Needs openpyxl (Debian package python3-openpyxl); run from the root of the tree.
import csv, datetime, openpyxl
from openpyxl.styles import numbers
wb = openpyxl.Workbook()
note = wb.active; note.title = 'Примітки'
note.append(['Журнал заміни інструменту, цех 3'])
ws = wb.create_sheet('Зняття')
rows = list(csv.reader(open('docs/examples/fit/removals.csv', encoding='utf-8-sig'), delimiter=';'))
for n, row in enumerate(rows):
    out = []
    for c in row:
        t = c.replace(',', '.')
        try: out.append(float(t))
        except ValueError: out.append(c if c != '' else None)
    ws.append(out)
for r in ws.iter_rows(min_row=2):
    for c in r:
        if isinstance(c.value, float): c.number_format = '0.0'
times = wb.create_sheet('Простої')
times.append(['Початок', 'Кінець', 'Причина'])
times.append([datetime.datetime(2026,3,2,7,15), datetime.datetime(2026,3,2,8,5), 'патрон'])
times.append([datetime.datetime(2026,3,3,9,0), datetime.datetime(2026,3,3,9,45,30), "патрон"])
times.append([datetime.datetime(2026,3,5,11,0), datetime.datetime(2026,3,5,11,30), "патрон"])
times.append([datetime.datetime(2026,3,9,12,0), datetime.datetime(2026,3,9,13,2), "патрон"])
times['A2'].number_format='DD.MM.YYYY HH:MM'; times['B2'].number_format='DD.MM.YYYY HH:MM'
wb.save('tests/data/removals.xlsx')
