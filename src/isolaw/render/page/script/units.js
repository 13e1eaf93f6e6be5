// The units in which the page shows values. Its data are stored in kN, mm and s. For each system of units they also
// give a factor and a name for every stored unit. The address of the page names the system: "#SECTION?units=kip-in".

const stored = JSON.parse(document.getElementById('isolaw-data').textContent);
const { systems, chosen, endings, own } = stored.units;
const asked = new URLSearchParams(location.hash.split('?')[1] ?? '').get('units');
const placeOf = (id) => systems.findIndex((one) => one.id === id);
const place = placeOf(asked) < 0 ? placeOf(chosen) : placeOf(asked);
const system = systems[place].units;

export const unitShown = (unit) => system[unit]?.unit ?? unit;
export const MM = unitShown('mm');
export const KN = unitShown('kN');
export const KN_MM = unitShown('kN mm');
export const UNIT_SYSTEMS = systems.map(({ id }) => id);
export const UNITS = UNIT_SYSTEMS[place];
export const isOtherThanReported = UNITS !== chosen;
export const isConverted = place > 0; // false: values are shown in the units in which they were given

// Returns how many decimals a converted value needs to be as precise as with `decimals` decimals in the stored unit.
export const decimalsIn = (unit, decimals) => Math.max(0, decimals - Math.round(Math.log10(system[unit]?.factor ?? 1)));
export const inUnits = (value, unit) => value * (system[unit]?.factor ?? 1);
// Returns Plotly's format for a number with its unit in a label, such as "%{x:.1f} mm".
export const hovered = (axis, unit, decimals) => '%{' + axis + ':.' + decimalsIn(unit, decimals) + 'f} ' + unitShown(unit);
export const LOOP_HOVER = hovered('x', 'mm', 1) + ', ' + hovered('y', 'kN', 1);

const unitOf = (key) => endings.find(([ending]) => ('_' + key).endsWith(ending))?.[1];

// Converts a value and everything inside it. The end of a key names the unit of the key's numbers. An object may
// instead name the unit of some of its numbers in its member `unit`; `own` lists the keys of these numbers. Parameters
// stay in the units of their law's formula. The coverage stays too: its keys name quantities, such as isolator_mm, but
// its numbers are shares of draws. A sentence that holds values is stored once for each system of units.
function converted(value, key, unit) {
  if (typeof value === 'number') return unit ? inUnits(value, unit) : value;
  if (value === null || typeof value !== 'object' || key === 'parameters' || key === 'coverage') return value;
  if (Array.isArray(value)) return value.map((item) => converted(item, key, unit));
  if (value.said) return value.said[place];
  const result = {};
  for (const [name, member] of Object.entries(value)) {
    const holdsObjects = typeof member === 'object' && typeof member?.[0] !== 'number';
    result[name] = converted(member, name, unitOf(name) ?? (own.includes(name) ? (value.unit ?? unit) : holdsObjects ? unit : undefined));
  }
  if (system[value.unit]) {
    result.unit = unitShown(value.unit);
    if ('decimals' in value) result.decimals = decimalsIn(value.unit, value.decimals);
  }
  return result;
}

export const data = converted(stored);
