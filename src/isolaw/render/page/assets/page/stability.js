// Stability

// Three panels beside one another, below one another where there is no room, with cycle numbers along their abscissa.
function followedPanels(stacked, largest) {
  const layout = { annotations: [] };
  FOLLOWED.forEach((property, i) => {
    const suffix = i === 0 ? '' : String(i + 1),
      gap = stacked ? 0.09 : 0.08,
      size = (1 - 2 * gap) / 3;
    const along = [i * (size + gap), i * (size + gap) + size];
    const down = [1 - along[1], 1 - along[0]];
    layout['xaxis' + suffix] = {
      domain: stacked ? [0, 1] : along,
      anchor: 'y' + suffix,
      range: [0.6, largest + 0.4],
      tickformat: 'd',
      dtick: Math.max(1, Math.ceil(largest / 10)),
      tick0: 1,
      zeroline: false,
      title: stacked && i < 2 ? '' : 'cycle',
      showticklabels: !stacked || i === 2,
    };
    layout['yaxis' + suffix] = {
      domain: stacked ? down : [0, 1],
      anchor: 'x' + suffix,
      title: property.title,
      zeroline: false,
      nticks: 5,
    };
  });
  return layout;
}

// Limits of a device in percent of the design value, as rule sets print them: "from -20 % to +20 %", "at least -25 %".
function limitBand(limit, nominal) {
  if (!isNumber(nominal) || !limit) return null;
  const numbers =
    String(limit)
      .replace(/\u2212/g, '-')
      .match(/[-+]?\d+(?:\.\d+)?(?= ?%)/g)
      ?.map(Number) ?? [];
  const at = (percent) => nominal * (1 + percent / 100);
  if (/^from [^%]*% to [^%]*%$/.test(limit) && numbers.length === 2) return numbers.map(at);
  if (/^at least .*%$/.test(limit) && numbers.length === 1) return [at(numbers[0]), null];
  if (/^at most .*%$/.test(limit) && numbers.length === 1) return [null, at(numbers[0])];
  return null;
}

// Design value and limits of a followed property: of one device's assessments, else of the lot.
function designOf(name, assessments) {
  const own = assessments.find(
    (a) => (a.quantity === name || a.quantity.startsWith(name + ',')) && isNumber(a.nominal),
  );
  const lot = lotQuantities.find((quantity) => quantity.quantity === name);
  const nominal = own?.nominal ?? lot?.nominal ?? null;
  return { nominal, band: limitBand(own?.limit || lot?.limit_individual, nominal) };
}

// A tenth of the values' size at least: what hardly changes from cycle to cycle shall look so.
function steadyRange(values) {
  const [low, high] = paddedRange(values, 0.08);
  const missing = Math.max(0, 0.1 * Math.max(...values.map(Math.abs)) - (high - low));
  return [low - missing / 2, high + missing / 2];
}

// The range of panel i, with the design value and the limits where there are any.
function framePanel(layout, look, i, { nominal, band }, values) {
  const some = values.filter(isNumber);
  if (some.length === 0) return;
  const suffix = i === 0 ? '' : String(i + 1);
  const [low, high] = steadyRange([...some, nominal, ...(band ?? [])].filter(isNumber));
  layout['yaxis' + suffix].range = [low, high];
  layout.shapes ??= [];
  const whole = { xref: 'x' + suffix + ' domain', yref: 'y' + suffix, x0: 0, x1: 1, layer: 'below' };
  if (band)
    layout.shapes.push({
      ...whole,
      type: 'rect',
      y0: band[0] ?? low,
      y1: band[1] ?? high,
      fillcolor: look.colour('band'),
      line: { width: 0 },
    });
  if (isNumber(nominal))
    layout.shapes.push({
      ...whole,
      type: 'line',
      y0: nominal,
      y1: nominal,
      line: { color: look.colour('good'), width: 1.2, dash: 'dash' },
    });
}

// The value of a cycle with its ratio to cycle 3, for reading off a plot.
function followedText(property, block, cycle, place) {
  const ratio = block.stability?.[property.name]?.ratio_to_third?.[place];
  return property.text(cycle[property.key]) + (isNumber(ratio) ? ', ' + fixed(ratio, 3) + ' of cycle 3' : '');
}

function emptyPlot(look, text) {
  return {
    traces: [],
    layout: {
      xaxis: { visible: false },
      yaxis: { visible: false },
      annotations: [
        {
          xref: 'paper',
          yref: 'paper',
          x: 0.5,
          y: 0.5,
          showarrow: false,
          text: plain(text),
          font: { size: 13, color: look.colour('muted') },
        },
      ],
    },
  };
}

function drawStability(look) {
  const device = devices[chosen.tested],
    blocks = chosenBlocks(device).filter((block) => counted(block).length > 0);
  if (blocks.length === 0) return emptyPlot(look, 'no cycle that counts');
  const layout = followedPanels(true, Math.max(...blocks.flatMap(counted).map((cycle) => cycle.number)));
  const traces = FOLLOWED.flatMap((property, i) =>
    blocks.map((block) => {
      const cycles = counted(block),
        suffix = i === 0 ? '' : String(i + 1),
        place = device.blocks.indexOf(block);
      return {
        name: 'block ' + block.number,
        legendgroup: String(block.number),
        showlegend: i === 0,
        mode: 'lines+markers',
        xaxis: 'x' + suffix,
        yaxis: 'y' + suffix,
        x: cycles.map((cycle) => cycle.number),
        y: cycles.map((cycle) => cycle[property.key]),
        text: cycles.map((cycle, k) => followedText(property, block, cycle, k)),
        line: { color: look.law({ index: place }), width: 1.4 },
        marker: { color: look.law({ index: place }), symbol: SYMBOLS[place % SYMBOLS.length], size: 6 },
        hovertemplate: 'cycle %{x}: %{text}<extra>block ' + block.number + '</extra>',
      };
    }),
  );
  const held = device.assessments.filter((a) => blocks.some((block) => a.block === block.number));
  FOLLOWED.forEach((property, i) =>
    framePanel(
      layout,
      look,
      i,
      held.length > 0 ? designOf(property.name, held) : { nominal: null, band: null },
      blocks.flatMap(counted).map((cycle) => cycle[property.key]),
    ),
  );
  return {
    traces,
    layout: { ...layout, showlegend: blocks.length > 1 && blocks.length <= 6, margin: { l: 58, r: 8, t: 6, b: 40 } },
  };
}

function stabilityCaption() {
  const device = devices[chosen.tested];
  // In a caption there is room for few: of many blocks the one that is reported.
  const blocks = chosenBlocks(device);
  const said = (blocks.length > 3 ? blocks.filter((block) => block.number === device.reported?.block) : blocks)
    .map((block) => {
      const [K, E] = [block.stability?.K_eff, block.stability?.energy];
      if (!isNumber(K?.first_to_third)) return null;
      const late =
        isNumber(K.min_2_10) && isNumber(K.max_2_10)
          ? '; cycles 2\u201310: K_eff ' + fixed(K.min_2_10, 2) + ' to ' + fixed(K.max_2_10, 2)
          : '';
      return (
        'Block ' +
        block.number +
        ': first cycle ' +
        fixed(K.first_to_third, 2) +
        ' in K_eff' +
        (isNumber(E?.first_to_third) ? ', ' + fixed(E.first_to_third, 2) + ' in energy' : '') +
        late +
        '.'
      );
    })
    .filter(Boolean);
  const held = device.assessments.some(
    (a) => FOLLOWED.some(({ name }) => a.quantity.startsWith(name)) && isNumber(a.nominal),
  );
  return (
    (said.length > 0
      ? 'Against cycle 3. ' +
        said.join(' ') +
        (blocks.length > 3 ? onScreen(' Choose a block above for the others.') : '')
      : 'No block has a third cycle to compare with.') + (held ? ' Dashed: design value; band: its limits.' : '')
  );
}

function stabilityData() {
  const columns = ['first_to_third', 'first_to_mean_1_3', 'min_2_10', 'max_2_10', 'min_1_10', 'max_1_10'];
  return {
    columns: [
      'device',
      'block',
      'property',
      'cycle',
      'value',
      'ratio to cycle 3',
      ...columns.map((c) => c + ' of the block'),
    ],
    rows: devices[chosen.tested].blocks.flatMap((block) =>
      FOLLOWED.flatMap((property) =>
        counted(block).map((cycle, k) => {
          const stability = block.stability?.[property.name];
          return [
            devices[chosen.tested].name,
            block.number,
            property.title,
            cycle.number,
            cycle[property.key],
            stability?.ratio_to_third?.[k],
            ...columns.map((c) => stability?.[c]),
          ];
        }),
      ),
    ),
  };
}

// The block of a device that the lot is compared by: the chosen one, else the one that is reported.
function comparedBlock(device) {
  const number = chosen.block === 'all' ? device.reported?.block : chosen.block;
  return device.blocks.find((block) => block.number === number) ?? null;
}

function lotStabilityCaption() {
  const shown = devices.filter((device) => comparedBlock(device));
  return (
    'One line a device, ' +
    (chosen.block === 'all' ? 'its reported block (the largest amplitude)' : 'block ' + chosen.block + ' of each') +
    '; bold: ' +
    (chosen.tested === null ? 'none' : devices[chosen.tested].name) +
    '. ' +
    count(shown.length, 'device') +
    '.' +
    (lotQuantities.some((quantity) => isNumber(quantity.nominal))
      ? ' Dashed: design value; band: limits of one device.'
      : '')
  );
}

function drawLotStability(look, width) {
  const entries = devices
    .map((device) => ({ device, block: comparedBlock(device) }))
    .filter(({ block }) => block && counted(block).length > 0);
  if (entries.length === 0) return emptyPlot(look, 'no device has this block');
  const layout = followedPanels(
    width < NARROW,
    Math.max(...entries.flatMap(({ block }) => counted(block).map((cycle) => cycle.number))),
  );
  const traces = FOLLOWED.flatMap((property, i) => {
    const suffix = i === 0 ? '' : String(i + 1);
    // All thin lines are one trace, broken between devices: 160 of them stay quick.
    const line = (among, bold) => {
      const x = [],
        y = [],
        text = [];
      for (const { device, block } of among) {
        counted(block).forEach((cycle, k) => {
          x.push(cycle.number);
          y.push(cycle[property.key]);
          text.push('<b>' + plain(device.name) + '</b><br>' + followedText(property, block, cycle, k));
        });
        x.push(null);
        y.push(null);
        text.push('');
      }
      return {
        mode: bold ? 'lines+markers' : 'lines',
        showlegend: false,
        xaxis: 'x' + suffix,
        yaxis: 'y' + suffix,
        x,
        y,
        text,
        opacity: bold ? 1 : entries.length > 40 ? 0.5 : 0.75,
        line: { color: look.colour(bold ? 'accent' : 'measured'), width: bold ? 2.6 : 0.9 },
        marker: { color: look.colour('accent'), size: 6 },
        hovertemplate: '%{text}<extra>cycle %{x}</extra>',
      };
    };
    return [
      line(
        entries.filter(({ device }) => device.index !== chosen.tested),
        false,
      ),
      line(
        entries.filter(({ device }) => device.index === chosen.tested),
        true,
      ),
    ];
  });
  FOLLOWED.forEach((property, i) =>
    framePanel(
      layout,
      look,
      i,
      designOf(property.name, []),
      entries.flatMap(({ block }) => counted(block).map((c) => c[property.key])),
    ),
  );
  return { traces, layout: { ...layout, margin: { l: 54, r: 8, t: 8, b: 44 } } };
}
