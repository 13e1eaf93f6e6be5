#!/usr/bin/env python3
"""Draws a moving picture of a campaign as SVG: two dots run along the measured loop and the loop of the law.

    PYTHONPATH=build/release/python /usr/bin/python3 tools/moving_loop.py CAMPAIGN DEVICE FILE.svg

The law is the one that the campaign recommends. It is drawn dashed where it was not fitted to the record. The picture of
the README is that of device B1 of the example tests (`./isolaw.sh run`).
"""
import sys

import isolaw
import numpy as np

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 400, 64, 16, 34, 50
SECONDS = 16
POINTS = 420  # samples drawn


def signed(value):
    return str(value).replace("-", "\u2212")


def was_fitted(campaign, law, device):
    """Returns for each sample of the cleaned record whether the law was fitted to the block that contains it."""
    times, raw = campaign.fit_record(device)["time_s"], campaign.record(device)
    fits = next(one for one in campaign.summary["laws"] if one["id"] == law)["devices"]
    scores = next(fit for fit in fits if fit["name"] == device)["blocks"]
    if not scores:
        return np.ones(len(times), bool)
    fitted = np.zeros(len(times), bool)
    blocks = isolaw.properties(raw)["blocks"]
    for number in (score["block"] for score in scores if score["fitted"]):
        cycles = next(block for block in blocks if block["number"] == number)["cycles"]
        first, last = np.interp([cycles[0]["first"], cycles[-1]["last"]], np.arange(len(raw)), raw.time_s)
        fitted |= (times >= first) & (times <= last)
    return fitted


def main(directory, device, file):
    campaign = isolaw.load(directory)
    law = campaign.summary["recommendation"]["law"]
    name = next(one["name"] for one in campaign.summary["laws"] if one["id"] == law)
    record, force = campaign.fit_record(device), campaign.force(law, device)
    every = max(1, len(force) // POINTS)
    x, measured, computed = record["disp_mm"][::every], record["force_kN"][::every], force[::every]
    scored = was_fitted(campaign, law, device)[::every]
    most_x, most_F = 1.06 * np.abs(x).max(), 1.12 * np.abs(measured).max()

    def across(value):
        return LEFT + (value / most_x + 1) / 2 * (WIDTH - LEFT - RIGHT)

    def down(value):
        return TOP + (1 - value / most_F) / 2 * (HEIGHT - TOP - BOTTOM)

    def path(F, inside):
        """Returns an SVG path with a line for each stretch of the record where `inside` is true."""
        text, open_ = "", False
        for a, b, shown in zip(x, F, inside):
            text += f"{'L' if open_ else 'M'}{across(a):.1f} {down(b):.1f}" if shown else ""
            open_ = shown
        return text

    def moving(F, colour, radius):
        places = ";".join(f"{across(a):.1f},{down(b):.1f}" for a, b in zip(x, F))
        return (f'<circle r="{radius}" fill="#fff" stroke="{colour}" stroke-width="2.5">'
                f'<animateMotion dur="{SECONDS}s" repeatCount="indefinite" calcMode="linear" values="{places}"/></circle>')

    reach = np.abs(x[scored]).max()
    ink, faint, muted, colour = "#1c2329", "#c3cad0", "#5a6670", "#1f5f93"
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
           'font-family="system-ui, sans-serif" font-size="13" role="img">',
           f"<title>Measured loop of {device} and the law {name}, fitted within {reach:.0f} mm, moving along the test</title>",
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>',
           f'<rect x="{across(-reach):.1f}" y="{TOP}" width="{across(reach) - across(-reach):.1f}" '
           f'height="{HEIGHT - TOP - BOTTOM}" fill="#f2f4f6"/>']
    for value in range(-int(most_x // 60) * 60, int(most_x) + 1, 60):
        out.append(f'<path d="M{across(value):.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="{faint}" stroke-width=".6"/>'
                   f'<text x="{across(value):.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle" fill="{muted}">{signed(value)}</text>')
    for value in range(-int(most_F // 50) * 50, int(most_F) + 1, 50):
        out.append(f'<path d="M{LEFT} {down(value):.1f}H{WIDTH - RIGHT}" stroke="{faint}" stroke-width=".6"/>'
                   f'<text x="{LEFT - 8}" y="{down(value) + 4:.1f}" text-anchor="end" fill="{muted}">{signed(value)}</text>')
    out += [f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" text-anchor="middle" fill="{muted}">displacement, mm</text>',
            f'<text x="16" y="{TOP - 12}" fill="{muted}">force, kN</text>',
            f'<text x="{across(reach) - 6:.1f}" y="{HEIGHT - BOTTOM - 8}" text-anchor="end" fill="{muted}" font-style="italic">fitted to these</text>',
            f'<text x="{across(reach) + 6:.1f}" y="{HEIGHT - BOTTOM - 8}" fill="{muted}" font-style="italic">predicted</text>',
            f'<path d="{path(measured, np.ones(len(x), bool))}" fill="none" stroke="{ink}" stroke-width="1.3" opacity=".55"/>',
            f'<path d="{path(computed, scored)}" fill="none" stroke="{colour}" stroke-width="1.6"/>',
            f'<path d="{path(computed, ~scored)}" fill="none" stroke="{colour}" stroke-width="1.6" stroke-dasharray="6 4"/>',
            moving(measured, ink, 6), moving(computed, colour, 6)]
    keys = [(100, ink, "measured", ""), (230, colour, f"{name}, fitted", ""), (460, colour, f"{name}, predicted", ' stroke-dasharray="6 4"')]
    for left, stroke, text, dashes in keys:
        out.append(f'<path d="M{left} {TOP - 16}h28" stroke="{stroke}" stroke-width="2"{dashes}/>'
                   f'<text x="{left + 34}" y="{TOP - 12}" fill="{ink}">{text}</text>')
    with open(file, "w", encoding="utf-8") as svg:
        svg.write("\n".join(out + ["</svg>", ""]))


if len(sys.argv) != 4:
    sys.exit(__doc__)
main(*sys.argv[1:])
