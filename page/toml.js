// Parses a lot file into tables, with the position of each key in the text. A form can then change one value and leave
// the rest of the text, with its comments, as it is. The parser knows only the part of TOML 1.0 that lot files use. The
// program itself checks the text.

class Reader {
  constructor(text) {
    this.text = text;
    this.at = 0;
  }

  fail(what) {
    const line = this.text.slice(0, this.at).split('\n').length;
    throw Object.assign(new SyntaxError(what), { line });
  }

  sees(words) {
    return this.text.startsWith(words, this.at);
  }

  take(pattern) {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    if (!found) return null;
    this.at += found[0].length;
    return found[0];
  }

  blanks(lines) {
    this.take(lines ? /(?:[ \t\r\n]|#[^\n]*)*/y : /[ \t]*/y);
  }

  need(sign) {
    if (!this.sees(sign)) this.fail(sign);
    this.at += sign.length;
  }

  key() {
    const parts = [];
    do {
      this.blanks();
      const bare = this.take(/[A-Za-z0-9_-]+/y);
      if (bare !== null) parts.push(bare);
      else if (this.sees('"') || this.sees("'")) parts.push(this.value());
      else this.fail('key');
      this.blanks();
    } while (this.take(/\./y));
    return parts.join('.');
  }

  value() {
    if (this.sees('"""') || this.sees("'''")) {
      const fence = this.text.substr(this.at, 3);
      const end = this.text.indexOf(fence, this.at + 3);
      if (end < 0) this.fail('string');
      const inside = this.text.slice(this.at + 3, end).replace(/^\r?\n/, '');
      this.at = end + 3;
      return inside;
    }
    if (this.sees("'")) {
      const literal = this.take(/'[^'\n]*'/y) ?? this.fail('string');
      return literal.slice(1, -1);
    }
    if (this.sees('"')) {
      const basic = this.take(/"(?:[^"\\\n]|\\.)*"/y) ?? this.fail('string');
      const signs = { b: '\b', t: '\t', n: '\n', f: '\f', r: '\r', '"': '"', '\\': '\\' };
      return basic.slice(1, -1).replace(/\\(u[0-9A-Fa-f]{4}|U[0-9A-Fa-f]{8}|.)/g, (_, sign) => {
        if (sign.length === 1) return signs[sign] ?? this.fail('escape');
        const point = parseInt(sign.slice(1), 16);
        return point <= 0x10ffff ? String.fromCodePoint(point) : this.fail('escape');
      });
    }
    if (this.sees('[')) {
      this.need('[');
      const items = [];
      for (this.blanks(true); !this.sees(']'); this.blanks(true)) {
        items.push(this.value());
        this.blanks(true);
        if (!this.sees(']')) this.need(',');
      }
      this.need(']');
      return items;
    }
    if (this.sees('{')) {
      this.need('{');
      const items = Object.create(null);
      for (this.blanks(); !this.sees('}'); this.blanks()) {
        const name = this.key();
        this.need('=');
        this.blanks();
        items[name] = this.value();
        this.blanks();
        if (!this.sees('}')) this.need(',');
      }
      this.need('}');
      return items;
    }
    const bare = this.take(/[^\s,\]}#][^,\]}#\n]*/y)?.trimEnd() ?? this.fail('value');
    if (bare === 'true' || bare === 'false') return bare === 'true';
    const number = Number(bare.replace(/_/g, ''));
    return Number.isNaN(number) ? bare : number;
  }
}

// Returns the tables of a text as [{path, array, keys, comments, from, to}]. The first table has the keys that stand
// before any heading. A table takes up text[from] to text[to]. `keys` maps a name to {from, to, value, valueFrom,
// valueTo}, and `comments` maps the name in a comment `# name = words` to {from, to, words}; `from` and `to` enclose
// whole lines.
export function readToml(text) {
  const reader = new Reader(text);
  const open = (path, array, from) => ({ path, array, keys: new Map(), comments: new Map(), from, to: from });
  const tables = [open('', false, 0)];
  while (reader.at < text.length) {
    const from = reader.at;
    reader.blanks();
    const table = tables.at(-1);
    if (reader.sees('[')) {
      const array = reader.sees('[[');
      reader.need(array ? '[[' : '[');
      tables.push(open(reader.key(), array, from));
      reader.need(array ? ']]' : ']');
    } else if (reader.sees('#')) {
      const comment = reader.take(/#[^\n]*/y);
      const [, name, words] = /^#\s*([A-Za-z0-9_-]+)\s*=\s*(.*)/.exec(comment) ?? [];
      if (name && !table.comments.has(name)) table.comments.set(name, { from, to: reader.at + 1, words });
    } else if (!/[\r\n]/.test(text[reader.at] ?? '\n')) {
      const name = reader.key();
      reader.need('=');
      reader.blanks();
      const valueFrom = reader.at;
      const value = reader.value();
      const valueTo = valueFrom + text.slice(valueFrom, reader.at).trimEnd().length;
      if (table.keys.has(name)) reader.fail(name);
      table.keys.set(name, { from, to: 0, value, valueFrom, valueTo });
    }
    reader.blanks();
    reader.take(/#[^\n]*/y);
    if (reader.at < text.length && reader.take(/\r?\n/y) === null) reader.fail('end of line');
    for (const key of table.keys.values()) key.to ||= reader.at;
    if (table === tables.at(-1)) table.to = table.keys.size > 0 || table.comments.size > 0 ? reader.at : table.to;
    else tables.at(-1).to = reader.at;
  }
  return tables;
}

export function writeValue(value) {
  if (Array.isArray(value)) return '[' + value.map(writeValue).join(', ') + ']';
  if (typeof value === 'object')
    return '{ ' + Object.entries(value).map(([name, one]) => (/^[A-Za-z0-9_-]+$/.test(name) ? name : writeValue(name)) + ' = ' + writeValue(one)).join(', ') + ' }';
  if (typeof value !== 'string') return String(value);
  const plain = !/['\u0000-\u001f\u007f]/.test(value);
  return plain ? "'" + value + "'" : JSON.stringify(value).replace(/\u007f/g, '\\u007f');
}

// Returns the text with the value of a key changed or added, or with the key removed if the value is null. `number` is
// the index of the table in the result of readToml().
export function withKey(text, number, name, value) {
  const table = readToml(text)[number];
  const key = table.keys.get(name);
  if (key && value === null) return text.slice(0, key.from) + text.slice(key.to);
  if (value === null) return text;
  if (key) return text.slice(0, key.valueFrom) + writeValue(value) + text.slice(key.valueTo);
  const line = name + ' = ' + writeValue(value) + '\n';
  const comment = table.comments.get(name);
  if (comment) return text.slice(0, comment.from) + line + text.slice(comment.to);
  // A new key stands below the last key of its table. In a table without keys it stands below the heading.
  const keys = [...table.keys.values()];
  const at = keys.length > 0 ? Math.max(...keys.map(({ to }) => to)) : table.path === '' ? 0 : lineEnd(text, table.from);
  const before = text.slice(0, at);
  return before + (before === '' || before.endsWith('\n') ? '' : '\n') + line + text.slice(at);
}

const lineEnd = (text, from) => {
  const end = text.indexOf('\n', from);
  return end < 0 ? text.length : end + 1;
};

// Does the same as withKey() for the table with the name `path`. A missing table is added above the first device.
export function withSetting(text, path, name, value) {
  const tables = readToml(text);
  const number = tables.findIndex((table) => table.path === path && !table.array);
  if (number >= 0) return withKey(text, number, name, value);
  if (value === null) return text;
  const device = tables.find(({ array }) => array);
  const at = device ? device.from : text.length;
  const before = text.slice(0, at);
  const gap = before === '' || before.endsWith('\n\n') ? '' : before.endsWith('\n') ? '\n' : '\n\n';
  return before + gap + '[' + path + ']\n' + name + ' = ' + writeValue(value) + '\n\n' + text.slice(at);
}

// Matches a number as people write it, such as -1.5e3. It does not match other notations such as 0x10.
export const NUMERAL = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

const entriesOf = (words) =>
  words.split(',').map((pair) => {
    const [name, value] = [pair.slice(0, pair.indexOf('=')).trim(), pair.slice(pair.indexOf('=') + 1).trim()];
    return [name, NUMERAL.test(value) ? Number(value) : value];
  });

// Returns {values, write} for a group such as `columns` in the table with index `number`: its values, and a function
// write(text, key, value) that changes them. A lot file can write a group in four ways: as an inline table, as a text
// such as "disp=a,force=b", as dotted keys, or as a table of its own. For a device, the heading [device.columns] of
// that table stands between [[device]] and the next [[device]].
export function valuesOf(tables, number, name) {
  const { path, array, keys } = tables[number];
  const heading = path + '.' + name;
  let below = array ? number + 1 : tables.findIndex((table) => table.path === heading);
  if (array) while (tables[below]?.path.startsWith(path + '.') && tables[below].path !== heading) ++below;
  const own = tables[below]?.path === heading ? tables[below] : null;
  const dotted = [...keys].filter(([key]) => key.startsWith(name + '.'));
  const inline = keys.get(name)?.value;
  const values = {
    ...(typeof inline === 'string' ? Object.fromEntries(entriesOf(inline)) : inline),
    ...Object.fromEntries(dotted.map(([key, { value }]) => [key.slice(name.length + 1), value])),
    ...(own && Object.fromEntries([...own.keys].map(([key, { value }]) => [key, value]))),
  };
  const write = (text, key, value) => {
    if (own) return withKey(text, below, key, value);
    if (dotted.length > 0) return withKey(text, number, name + '.' + key, value);
    const next = { ...values, [key]: value };
    if (value === null) delete next[key];
    return withKey(text, number, name, Object.keys(next).length > 0 ? next : null);
  };
  return { values, write };
}

// Does the same as valuesOf() for the table with the name `path`, which may be missing.
export function settingsOf(tables, path, name) {
  const number = tables.findIndex((table) => table.path === path && !table.array);
  if (number >= 0) return valuesOf(tables, number, name);
  const heading = path + '.' + name;
  const own = tables.find((table) => table.path === heading);
  const values = own ? Object.fromEntries([...own.keys].map(([key, { value }]) => [key, value])) : {};
  const write = (text, key, value) => (own ? withSetting(text, heading, key, value) : value === null ? text : withSetting(text, path, name, { [key]: value }));
  return { values, write };
}

// Returns the indices of the tables that describe devices.
export const deviceTables = (tables) => tables.flatMap(({ path, array }, number) => (path === 'device' && array ? [number] : []));

// Returns the text without a table and the tables below it that belong to it, such as the tests of a device.
export function withoutTable(text, number) {
  const tables = readToml(text);
  let last = number;
  while (tables[last + 1]?.path.startsWith(tables[number].path + '.')) ++last;
  return text.slice(0, tables[number].from) + text.slice(tables[last].to).replace(/^\n/, '');
}
