#!/usr/bin/env python3
"""Writes the files of this folder. Each is the record of a test with one oddity of a laboratory's export (a wart).

Most records are of a device with K = 0.5 kN/mm and friction of 20 kN. They have three cycles of 100 mm at 0.5 Hz with
100 samples a cycle, so K_eff is 0.7 kN/mm. Records with impossible signals (disp-*, force-*, time-gap) or unusual but
possible ones (true*) are of a smooth device: 0.5 kN/mm and 30 kN that follow the displacement within 12.5 mm. Its K_eff
is 0.8 kN/mm. warts.json states the expected outcome of each file, and tests/cli/warts_test.cpp checks it."""
import datetime
import json
import math
import os
import zipfile

here = os.path.dirname(os.path.abspath(__file__))
interval = 0.02


def samples():
    z = previous = 0.0
    for i in range(301):
        x = 100.0 * math.sin(2.0 * math.pi * i / 100.0)
        z = max(-1.0, min(1.0, z + (x - previous) / 10.0))
        previous = x
        yield interval * i, x, 0.5 * x + 20.0 * z


device = list(samples())
morning = datetime.datetime(2024, 5, 2, 10, 0, 0, 250000)


def write(name, data):
    with open(os.path.join(here, name), 'wb') as file:
        file.write(data)


def table(name, head, row, foot='', encoding='utf-8', end='\n', source=device):
    lines = ([head] if head else []) + [row(t, x, f) for t, x, f in source]
    write(name, (end.join(lines) + end + foot.replace('\n', end)).encode(encoding))


def stamp(form, t, start=morning, cut=0):
    text = (start + datetime.timedelta(seconds=t)).strftime(form)
    return text[:len(text) - cut]


def plain(t, x, f):
    return f'{t:.2f};{x:.3f};{f:.3f}'


def comma(value, digits=3):
    return f'{value:.{digits}f}'.replace('.', ',')


english = 'Time [s];Displacement [mm];Force [kN]'
tail = ';Displacement [mm];Force [kN]'


def timed(name, head, form, start=morning, cut=3, suffix=''):
    table(name, head + tail, lambda t, x, f: f'{stamp(form, t, start, cut)}{suffix};{x:.3f};{f:.3f}')


def time_stamps():
    night = datetime.datetime(2024, 5, 2, 23, 59, 57)
    timed('iso.csv', 'Timestamp', '%Y-%m-%dT%H:%M:%S.%f')
    timed('iso-zone.csv', 'Timestamp', '%Y-%m-%dT%H:%M:%S.%f', suffix='+02:00')
    timed('iso-utc.csv', 'DateTime', '%Y-%m-%d %H:%M:%S.%f', suffix='Z')
    table('iso-blanks.txt', 'Time Displacement[mm] Force[kN]',
          lambda t, x, f: f"{stamp('%Y-%m-%d %H:%M:%S.%f', t)} {x:.3f} {f:.3f}")
    timed('iso-basic.csv', 'Timestamp', '%Y%m%dT%H%M%S.%f')
    timed('clock.csv', 'Time', '%H:%M:%S.%f')
    timed('clock-midnight.csv', 'Uhrzeit', '%H:%M:%S.%f', night)
    timed('clock-unit.csv', 'Time [hh:mm:ss.fff]', '%H:%M:%S.%f')
    timed('clock-minutes.csv', 'Time', '%M:%S.%f')
    table('clock-pm.csv', 'Time' + tail, lambda t, x, f: f"{stamp('%I:%M:%S.%f', t, night, 3)} {'PM' if t < 3 else 'AM'};{x:.3f};{f:.3f}")
    timed('clock-coarse.csv', 'Time', '%H:%M:%S', cut=0)
    timed('day-first.csv', 'Datum', '%d.%m.%Y %H:%M:%S,%f', morning + datetime.timedelta(days=12))
    timed('month-first.csv', 'Date', '%m/%d/%Y %H:%M:%S.%f', morning + datetime.timedelta(days=12))
    timed('month-name.csv', 'Date', '%d-%b-%Y %H:%M:%S.%f')
    timed('day-or-month.csv', 'Date', '%d/%m/%Y %H:%M:%S.%f')
    timed('day-or-month-midnight.csv', 'Date', '%d/%m/%Y %H:%M:%S.%f', night)
    open_dates = [(i, x, f) for i, (t, x, f) in enumerate(device)]
    table('day-or-month-open.csv', 'Date' + tail,
          lambda t, x, f: f'{1 + t // 101:02}/{2 + t // 101:02}/2024 10:{t % 101 // 60:02}:{t % 101 % 60:02};{x:.3f};{f:.3f}', source=open_dates)
    table('date-and-clock.csv', 'Datum;Uhrzeit;Weg [mm];Kraft [kN];Raum',
          lambda t, x, f: f"{stamp('%d.%m.%Y', t, night)};{stamp('%H:%M:%S,%f', t, night, 3)};{comma(x)};{comma(f)};20,5")
    table('serial-days.csv', 'Date/Time' + tail, lambda t, x, f: f'{45414.4 + t / 86400.0:.10f};{x:.3f};{f:.3f}')
    table('days-as-seconds.csv', 'Time [s]' + tail, lambda t, x, f: f'{45414.4 + t / 86400.0:.10f};{x:.3f};{f:.3f}')
    table('uptime.csv', 'Time' + tail, lambda t, x, f: f'{40000.0 + t / 4.0:.3f};{x:.3f};{f:.3f}')
    table('two-clocks.csv', 'Logged;Sent' + tail,
          lambda t, x, f: f"{stamp('%H:%M:%S.%f', t, cut=3)};{stamp('%H:%M:%S.%f', t + 1, cut=3)};{x:.3f};{f:.3f}")
    table('clock-beside-seconds.csv', 'Time;Elapsed time [s]' + tail,
          lambda t, x, f: f"{stamp('%H:%M:%S', t)};{t:.2f};{x:.3f};{f:.3f}")
    workbook('date-cells.xlsx', 'Date and time', lambda t: 45414.4 + t / 86400.0)


def workbook(name, head, time):
    """Writes the smallest workbook that Excel can read. Cells of the first column have style 1, a date and time."""
    def text(content):
        return f'<c t="inlineStr"><is><t>{content}</t></is></c>'
    rows = '<row>' + text(head) + text('Displacement [mm]') + text('Force [kN]') + '</row>'
    for t, x, f in device:
        rows += f'<row><c s="1"><v>{time(t):.12f}</v></c><c><v>{x:.3f}</v></c><c><v>{f:.3f}</v></c></row>'
    parts = {
        '[Content_Types].xml': '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="xml" ContentType="application/xml"/><Override PartName="/xl/workbook.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/><Override PartName="/xl/worksheets/sheet1.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml"/><Override PartName="/xl/styles.xml" ContentType="application/vnd.openxmlformats-officedocument.spreadsheetml.styles+xml"/></Types>',
        '_rels/.rels': '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>',
        'xl/workbook.xml': '<workbook xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"><sheets><sheet name="Test" sheetId="1" r:id="r1"/></sheets></workbook>',
        'xl/_rels/workbook.xml.rels': '<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r1" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/><Relationship Id="r2" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/styles" Target="styles.xml"/></Relationships>',
        'xl/styles.xml': '<styleSheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><fonts count="1"><font/></fonts><fills count="1"><fill/></fills><borders count="1"><border/></borders><cellStyleXfs count="1"><xf/></cellStyleXfs><cellXfs count="2"><xf numFmtId="0"/><xf numFmtId="22" applyNumberFormat="1"/></cellXfs></styleSheet>',
        'xl/worksheets/sheet1.xml': f'<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><sheetData>{rows}</sheetData></worksheet>',
    }
    with zipfile.ZipFile(os.path.join(here, name), 'w', zipfile.ZIP_DEFLATED) as archive:
        for entry, content in parts.items():
            # A zip file holds the date of each entry. It is fixed here, so that the file has the same bytes every time.
            info = zipfile.ZipInfo(entry, (2024, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(info, content)


def parts_of_files():
    table('footer-statistics.csv', english, plain, foot='Max;100.000;70.000\nMin;-100.000;-70.000\nMean;0.0;0.0\n')
    table('footer-signature.csv', english, plain, foot='\nTested by: A. Smith\nEnd of data\n')
    table('footer-label-column.csv', 'No;Displacement [mm];Force [kN]', lambda t, x, f: f'{round(t / interval) + 1};{x:.3f};{f:.3f}',
          foot='Max;100.000;70.000\n')
    table('footer-number.csv', english, plain, foot='1234\n')
    table('broken-off.csv', english, plain, foot='6.02;12')
    table('overload-at-end.csv', english, plain, foot=''.join(f'{6.02 + 0.02 * i:.2f};0.0;9.9e37\n' for i in range(3)))
    table('approach.csv', english, plain, source=[(0.02 * i, 40.0 * math.sin(0.4 * i), 5.0) for i in range(100)] + [(t + 2.0, x, f) for t, x, f in device])
    table('thousands-english.csv', 'Time [s];Displacement [mm];Force [N]', lambda t, x, f: f'{t:.2f};{x:.3f};{1000 * f:,.1f}')
    table('thousands-german.csv', 'Zeit [s];Weg [mm];Kraft [N]',
          lambda t, x, f: f'{comma(t, 2)};{comma(x)};' + f'{1000 * f:,.1f}'.replace(',', '_').replace('.', ',').replace('_', '.'))
    table('thousands-swiss.csv', 'Zeit [s];Weg [mm];Kraft [N]', lambda t, x, f: f'{t:.2f};{x:.3f};' + f'{1000 * f:,.1f}'.replace(',', "'"))
    table('thousands-whole.csv', 'Displacement [mm];Force [N]', lambda t, x, f: f'{x:.3f};{1000 * f:,.0f}')
    table('thousands-blank.csv', 'Temps [s];Déplacement [mm];Force [N]',
          lambda t, x, f: f'{comma(t, 2)};{comma(x)};' + f'{1000 * f:,.1f}'.replace('.', '_').replace(',', '\u202f').replace('_', ','))
    table('only-displacement.csv', 'Time [s];Displacement [mm]', lambda t, x, f: f'{t:.2f};{x:.3f}')
    table('only-force.csv', 'Time [s];Force [kN]', lambda t, x, f: f'{t:.2f};{f:.3f}')
    table('only-force-slower.csv', 'Time [s];Force [kN]', lambda t, x, f: f'{t:.2f};{f:.3f}', source=device[1::2])
    table('only-force-gap.csv', 'Time [s];Force [kN]', lambda t, x, f: f'{t:.2f};{f:.3f}', source=device[:120] + device[160:])
    table('only-force-untimed.txt', 'Force [kN]', lambda t, x, f: f'{f:.3f}')
    table('only-force-shorter.txt', 'Force [kN]', lambda t, x, f: f'{f:.3f}', source=device[:290])
    table('only-displacement-stamped.csv', 'Time;Displacement [mm]', lambda t, x, f: f"{stamp('%H:%M:%S.%f', t, cut=3)};{x:.3f}")
    table('only-force-stamped.csv', 'Time;Force [kN]', lambda t, x, f: f"{stamp('%H:%M:%S.%f', t, cut=3)};{f:.3f}", source=device[:-20])
    table('one-column.txt', 'Displacement [mm]', lambda t, x, f: f'{x:.3f}')


def units_and_names():
    table('unit-in-point.csv', 'Time (min),Displ. (in.),Force (kip)',
          lambda t, x, f: f'{t / 60:.7f},{x / 25.4:.6f},{f / 4.4482216152605:.6f}')
    table('unit-tonnes.csv', 'Tempo [s];Spostamento [cm];Forza [t]', lambda t, x, f: f'{comma(t, 2)};{comma(x / 10, 4)};{comma(f / 9.80665, 5)}')
    table('unit-row-tonnes.csv', 'Time;Displacement;Force\ns;mm;t', lambda t, x, f: f'{t:.2f};{x:.3f};{f / 9.80665:.5f}')
    table('name-min-max.csv', english + ';Force min;Force max [kN]', lambda t, x, f: plain(t, x, f) + ';-70;70')
    for encoding, suffix in (('utf-8', 'utf8'), ('cp932', 'shift-jis')):
        table(f'japanese-{suffix}.csv', '試験体番号,LRB-7\n試験温度,23.5 ℃\n時間(s),水平変位(mm),水平荷重(kN),鉛直荷重(kN)',
              lambda t, x, f: f'{t:.2f},{x:.3f},{f:.3f},{1000 + x / 100:.2f}', encoding=encoding, end='\r\n')
    table('japanese-wide.csv', '時間（ｓ）,変位（㎜）,せん断力（ｋＮ）,温度', lambda t, x, f: f'{t:.2f},{x:.3f},{f:.3f},23.5')
    table('japanese-stamps.csv', '日時,変位(mm),せん断力(kN)', lambda t, x, f: f"{stamp('%Y年%m月%d日 %H:%M:%S.%f', t, cut=3)},{x:.3f},{f:.3f}", encoding='cp932')
    table('units-apart.csv', 'Zaman, dk;Deplasman, mm;Kesme kuvveti, t', lambda t, x, f: f'{t / 60:.7f};{x:.3f};{f / 9.80665:.5f}')
    table('unix-seconds.csv', 'Timestamp' + tail, lambda t, x, f: f'{1714644000.25 + t:.3f};{x:.3f};{f:.3f}')
    table('japanese-load.csv', '時間[s],変位[mm],荷重[kN]', lambda t, x, f: f'{t:.2f},{x:.3f},{f:.3f}')
    for encoding, suffix in (('utf-8', 'utf8'), ('cp1254', '1254')):
        table(f'turkish-{suffix}.csv', 'Seri No: İ-12\nZaman [s];Yer değiştirme [mm];Yatay kuvvet [kN];Düşey yük [kN];Sıcaklık',
              lambda t, x, f: f'{comma(t, 2)};{comma(x)};{comma(f)};{comma(1000 + x / 100, 2)};23', encoding=encoding)
    table('windows-1252.csv', 'Specimen: n° 7\nTemps [s];Déplacement [mm];Force [kN]', plain, encoding='cp1252')


def text_files():
    table('bom-crlf.csv', english, plain, encoding='utf-8-sig', end='\r\n')
    table('carriage-returns.csv', english, plain, end='\r')
    table('quoted.csv', '"Time [s]","Displacement [mm]","Force [kN]"', lambda t, x, f: f'"{comma(t, 2)}","{comma(x)}","{comma(f)}"')
    table('trailing-separator.csv', english + ';', lambda t, x, f: plain(t, x, f) + ';')
    table('blank-lines.csv', english, lambda t, x, f: plain(t, x, f) + ('\n' if round(t / interval) % 50 == 0 else ''))
    table('end-of-file-mark.csv', english, plain, foot='\x1a')
    table('comments.csv', '# Specimen: D07\n# rig: west\n' + english, plain, foot='# end\n')
    table('not-a-number.csv', english, lambda t, x, f: plain(t, x, f) if t != 3.0 else f'{t:.2f};{x:.3f};NaN')
    table('decimal-of-both.csv', english, lambda t, x, f: plain(t, x, f) if t != 3.0 else f'{t:.2f};{comma(x)};{f:.3f}')
    table('repeated-header.csv', english, lambda t, x, f: plain(t, x, f) + ('\n' + english if t == 3.0 else ''))
    table('time-restarts.csv', english, lambda t, x, f: plain(t if t < 3.0 else t - 3.0, x, f))
    table('counter.csv', 'Sample;Displacement [mm];Force [kN]', lambda t, x, f: f'{round(t / interval)};{x:.3f};{f:.3f}')
    table('no-units.csv', 'Time;Displacement;Force', plain)
    table('no-names.csv', '', plain)
    table('device-facts.csv', 'Serial No: S-101;;\nLot;L7;\nDate: 2024-05-02;;\nTemperature;23,5;°C\nTotal rubber thickness: 208 mm;;\n' + english.replace('.', ','),
          lambda t, x, f: f'{comma(t, 2)};{comma(x)};{comma(f)}')
    write('utf-16.csv', (english + '\n' + '\n'.join(plain(*s) for s in device)).encode('utf-16'))
    write('empty.csv', b'')


# Writes load and displacement of a compression test. The load rises `loadings` times from `least` to `largest` kN along
# the curve disp_of(load), in mm, and falls again with some hysteresis. During the first loading the device also
# settles: the settlement grows with the load up to `settles` mm and then stays.
def compression(name, head, disp_of, loadings=3, least=50.0, largest=1000.0, load_sign=1.0, settles=0.02, unloads=True, end=math.inf):
    lines = [head]
    for number in range(loadings):
        for i in range(100 if unloads else 51):
            load = least + (largest - least) * 0.5 * (1.0 - math.cos(2.0 * math.pi * i / 100.0))
            back = 0.03 * math.sin(math.pi * (load - least) / (largest - least)) if i > 50 else 0.0
            settled = settles * min(number + (load - least) / (largest - least) if number == 0 else 1.0, 1.0)
            lines.append(f'{min(disp_of(load) + back + settled, end):.5f};{load_sign * load:.3f}')
    write(name, ('\n'.join(lines) + '\n').encode())


def compression_tests():
    english = 'Vertical displacement [mm];Vertical load [kN]'
    compression('compression.csv', english, lambda p: 0.3 + p / 1200.0)
    # The device stiffens as d ~ P^0.8. From 300 to 1000 kN the displacement grows by 700/1200 mm, so K_v is 1200 kN/mm.
    scale = 700.0 / 1200.0 / (1000.0 ** 0.8 - 300.0 ** 0.8)
    compression('compression-ramp.csv', 'Displacement [mm];Load [kN]', lambda p: scale * p ** 0.8, loadings=1, least=0.0, settles=0.0, unloads=False)
    compression('compression-negative.csv', 'Weg vertikal [mm];Vertikalkraft [kN]', lambda p: 0.3 + p / 1200.0, load_sign=-1.0)
    compression('compression-preload.csv', english, lambda p: p / 1200.0, least=400.0)
    compression('compression-clipped.csv', english, lambda p: 0.3 + p / 1200.0, end=0.9)


def machine(name, head, row, encoding='utf-8', end='\r\n'):
    table(name, head, row, encoding=encoding, end=end)


# Writes the test in the file formats of testing machines and measuring amplifiers.
def machines():
    tabs = lambda t, x, f: f'{t:.4f}\t{x:.4f}\t{f:.4f}'
    machine('mts-793.dat', 'MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A\r\n\r\nData Acquisition\t\tTime:\t6.02\tSec\t5/2/2024 10:00:06 AM\r\n'
            'Running Time\tHorizontal Displacement\tHorizontal Force\r\nSec\tmm\tkN', tabs)
    machine('mts-793-german.dat', 'MTS793|MPT|DEU|1|2|,|.|:|49|1|1|A\r\n\r\nDatenerfassung\t\tZeit:\t6,02\tSek\t02.05.2024 10:00:06\r\n'
            'Zeit\tAchse-1 Weg\tAchse-1 Kraft\r\nSek\tmm\tN', lambda t, x, f: f'{comma(t, 4)}\t{comma(x, 4)}\t{comma(1000.0 * f, 2)}', encoding='cp1252')
    machine('mts-793-axial.dat', 'MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A\r\n\r\nData Acquisition\t\tTime:\t6.02\tSec\t5/2/2024 10:00:06 AM\r\n'
            'Time\tAxial Displacement\tAxial Force\r\nsec\tmm\tkN', tabs)
    machine('mts-testsuite.csv', '"File Path: C:\\Tests\\Lot 7"\r\n"Test: Shear"\r\n"Test Run: D07"\r\n"Date: 5/2/2024 10:00:00 AM"\r\n\r\n\r\n'
            '"Running Time ","Horizontal Displacement ","Horizontal Force "\r\n"sec","mm","kN"', lambda t, x, f: f'"{t:.4f}","{x:.4f}","{f:.4f}"', encoding='utf-8-sig')
    machine('bluehill-3.csv', 'Time,Extension,Load\r\n(s),(mm),(N)', lambda t, x, f: f'"{t:.4f}","{x:.4f}","{1000.0 * f:.2f}"')
    machine('bluehill-universal.csv', 'Results Table 1\r\n,Maximum Force [kN]\r\n1,70\r\n\r\nRaw Data\r\nTime [s],Displacement [mm],Force [kN]',
            lambda t, x, f: f'{t:.4f},{x:.4f},{f:.4f}')
    machine('dasylab.asc', 'DASYLab - V 13.00.00\r\nWorksheet name: shear\r\nRecording date     : 5/2/2024, 10:00:00 AM\r\nBlock length       : 2\r\n'
            'Delta              : 0.02 sec.\r\nNumber of channels : 2\r\nMeasurement time[s]\tDisp [mm]\tForce [kN]\t', lambda t, x, f: tabs(t, x, f) + '\t')
    machine('labview.lvm', 'LabVIEW Measurement\t\r\nWriter_Version\t2\r\nReader_Version\t2\r\nSeparator\tTab\r\nDecimal_Separator\t.\r\nMulti_Headings\tNo\r\n'
            'X_Columns\tOne\r\nTime_Pref\tRelative\r\nOperator\tLaboratory\r\nDate\t2024/05/02\r\nTime\t10:00:00.25\r\n***End_of_Header***\t\r\n\t\r\n'
            'Channels\t2\t\t\r\nSamples\t301\t301\t\r\nDate\t2024/05/02\t2024/05/02\t\r\nTime\t10:00:00.25\t10:00:00.25\t\r\n'
            'Y_Unit_Label\tmm\tkN\t\r\nX_Dimension\tTime\tTime\t\r\nX0\t0.0E+0\t0.0E+0\t\r\nDelta_X\t0.020000\t0.020000\t\r\n***End_of_Header***\t\t\t\r\n'
            'X_Value\tDisplacement\tForce\tComment', tabs)
    # These files have no time column. The header states the sampling interval of each channel, and isolaw makes the
    # time from it if all channels have the same.
    head = ('LabVIEW Measurement\t\r\nSeparator\tTab\r\nDecimal_Separator\t.\r\nX_Columns\tNo\r\n***End_of_Header***\t\r\n\t\r\n'
            'Channels\t2\t\t\r\nSamples\t301\t301\t\r\nY_Unit_Label\tmm\tkN\t\r\nX_Dimension\tTime\tTime\t\r\nX0\t0.0E+0\t0.0E+0\t\r\n'
            'Delta_X\t{}\t0.020000\t\r\n***End_of_Header***\t\t\t\r\nX_Value\tDisplacement\tForce\tComment')
    for name, interval_of_one in (('labview-no-x.lvm', '0.020000'), ('labview-two-rates.lvm', '0.010000')):
        machine(name, head.format(interval_of_one), lambda t, x, f: f'\t{x:.4f}\t{f:.4f}')
    write('machine.tdm', b'<?xml version="1.0" encoding="UTF-8" standalone="no" ?>\n<usi:tdm xmlns:usi="http://www.ni.com/Schemas/USI/1_0" version="1.0">\n</usi:tdm>\n')
    write('machine.tdms', b'TDSm' + bytes(24))
    write('machine.id_comp', b'TDAT' + bytes(24))


# Writes JSON files whose times are texts such as "2024-05-02T10:00:00.250".
def json_stamps():
    def arrays(name, times):
        write(name, json.dumps({'time': times, 'disp_mm': [round(x, 3) for _, x, _ in device], 'force_kN': [round(f, 3) for _, _, f in device]}).encode())

    iso = [stamp('%Y-%m-%dT%H:%M:%S.%f', t, cut=3) for t, _, _ in device]
    arrays('iso.json', iso)
    arrays('iso-and-seconds.json', iso[:200] + [round(t, 2) for t, _, _ in device[200:]])
    write('iso-rows.json', json.dumps([{'Timestamp': when, 'disp_mm': round(x, 3), 'force_kN': round(f, 3)}
                                       for when, (_, x, f) in zip(iso, device)]).encode())


def sine(i):
    return 100.0 * math.sin(2.0 * math.pi * i / 100.0)


def triangle(i):
    part = i % 100 / 100.0
    return 400.0 * part if part < 0.25 else 200.0 - 400.0 * part if part < 0.75 else 400.0 * part - 400.0


def smooth(motion, count=301):
    z = previous = 0.0
    rows = []
    for i in range(count):
        x = motion(i)
        if x != previous:
            z += (math.copysign(1.0, x - previous) - z) * (1.0 - math.exp(-abs(x - previous) / 12.5))
        previous = x
        rows.append((interval * i, x, 0.5 * x + 30.0 * z))
    return rows


def signals():
    def signal(name, rows):
        table(name, 'time [s],disp [mm],force [kN]', lambda t, x, f: f'{t:.3f},{x:.3f},{f:.3f}', source=rows)

    def rounded(value, step):
        return step * round(value / step)

    true = smooth(sine)
    signal('true.csv', true)
    signal('true-trapezoid.csv', smooth(lambda i: max(-100.0, min(100.0, 0.7 * triangle(i) / 0.5))))
    signal('true-triangle.csv', smooth(triangle))
    signal('true-one-sided.csv', smooth(lambda i: 50.0 - 50.0 * math.cos(2.0 * math.pi * i / 100.0)))
    signal('true-coarse-digitiser.csv', [(t, rounded(x, 0.5), rounded(f, 0.4)) for t, x, f in true])
    signal('true-rests.csv', smooth(lambda i: sine(i - 30) if 30 < i < 330 else 0.0, 361))
    signal('true-friction.csv', [(interval * i, x, 0.2 * x + 40.0 * (1.0 if (i - 1) % 100 < 25 or (i - 1) % 100 >= 75 else -1.0))
                                 for i, x in enumerate(map(triangle, range(301)))])
    signal('disp-clipped-both-sides.csv', [(t, max(-95.0, min(95.0, x)), f) for t, x, f in true])
    signal('disp-clipped-one-side.csv', [(t, min(98.0, x), f) for t, x, f in true])
    signal('force-clipped.csv', [(t, x, max(-70.0, min(70.0, f))) for t, x, f in true])
    stuck = true[110][1]
    signal('disp-stuck-then-jumps.csv', [(t, stuck if 111 <= i <= 121 else x, f) for i, (t, x, f) in enumerate(true)])
    signal('disp-stuck-then-goes-on.csv', [(t, true[i if i <= 110 else max(110, i - 12)][1], f) for i, (t, x, f) in enumerate(true)])
    signal('force-stuck.csv', [(t, x, true[205][2] if 206 <= i <= 217 else f) for i, (t, x, f) in enumerate(true)])
    signal('disp-rectified.csv', [(t, abs(x), f) for t, x, f in true])
    signal('force-rectified.csv', [(t, x, abs(f)) for t, x, f in true])

    def spoilt(name, channel, by):
        rows = [list(row) for row in true]
        for i, more in by.items():
            rows[i][channel] += more
        signal(name, rows)

    spoilt('force-spike.csv', 2, {127: 5.0})
    spoilt('disp-spike.csv', 1, {160: -20.0})
    spoilt('force-spikes.csv', 2, {60: 6.0, 133: -9.0, 241: 15.0})
    spoilt('force-dropout.csv', 2, {170: -true[170][2]})
    signal('force-dropouts.csv', [(t, x, 0.0 if 163 <= i <= 168 else f) for i, (t, x, f) in enumerate(true)])
    signal('disp-dropouts.csv', [(t, -9.9 if 215 <= i <= 219 else x, f) for i, (t, x, f) in enumerate(true)])
    signal('time-gap.csv', [(t + (2.5 if i > 140 else 0.0), x, f) for i, (t, x, f) in enumerate(true)])


time_stamps()
parts_of_files()
units_and_names()
text_files()
compression_tests()
machines()
json_stamps()
signals()
