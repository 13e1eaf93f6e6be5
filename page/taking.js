// Turns dropped or chosen files into a list of files with paths: it walks through folders, unpacks zip files and makes
// names safe.

import { unseen } from './dom.js';
import { text } from './text.js';
import { TooLarge, looksLikeZip, readZip } from './zip.js';

const MOST = 768 * 1024 * 1024; // bytes of all files together; every worker holds a copy of them

// Names of record files that are read from a folder (docs/records.md). A single file is read whatever its name is.
const RECORD = /\.(csv|tsv|txt|dat|asc|lvm|mat|xlsx|json)$/i;

const failure = (message) => Object.assign(new Error(message), { shown: true });

// Returns a path that cannot leave its folder and has no characters that file systems or lot files refuse.
function safePath(path) {
  const parts = path.replace(/\\/g, '/').split('/').filter((part) => part !== '' && part !== '.' && part !== '..');
  return parts.map((part) => part.replace(unseen, '_')).join('/');
}

// Lists the files of a folder by its file system handle. In Chromium the older interface of entries does not work for a
// page that was opened from a file.
async function walkHandle(directory, folder, found) {
  for await (const [name, handle] of directory.entries()) {
    if (handle.kind === 'file') found.push({ path: folder + name, file: await handle.getFile(), inFolder: true });
    else if (!name.startsWith('.')) await walkHandle(handle, folder + name + '/', found);
  }
}

// Lists the files of a folder by its entry, for browsers that have no file system handles.
async function walkEntry(directory, folder, found) {
  const reader = directory.createReader();
  const some = () => new Promise((resolve, reject) => reader.readEntries(resolve, reject));
  for (let entries = await some(); entries.length > 0; entries = await some())
    for (const entry of entries) {
      if (entry.isFile) found.push({ path: folder + entry.name, file: await new Promise((resolve, reject) => entry.file(resolve, reject)), inFolder: true });
      else if (!entry.name.startsWith('.')) await walkEntry(entry, folder + entry.name + '/', found);
    }
}

// Returns the dropped files as [{path, file, inFolder}]. Call it within the event handler, because the browser empties
// `transfer` afterwards.
export const ofDrop = (transfer) => {
  const dropped = [...transfer.items]
    .filter(({ kind }) => kind === 'file')
    .map((item) => {
      const entry = item.webkitGetAsEntry?.();
      if (!entry?.isDirectory) return { file: item.getAsFile() };
      return { entry, handle: item.getAsFileSystemHandle?.() };
    });
  return (async () => {
    const found = [];
    for (const { file, entry, handle } of dropped) {
      if (file) found.push({ path: file.name, file, inFolder: false });
      else if (entry) {
        try {
          if (handle) await walkHandle(await handle, entry.name + '/', found);
          else await walkEntry(entry, entry.name + '/', found);
        } catch {
          throw failure(text.unreadableFolder(entry.name));
        }
      }
    }
    return found.sort((a, b) => (a.path < b.path ? -1 : 1)); // file managers show a folder in this order
  })();
};

export const ofInput = (input) =>
  [...input.files].map((file) => ({ path: file.webkitRelativePath || file.name, file, inFolder: Boolean(file.webkitRelativePath) })).sort((a, b) => (a.path < b.path ? -1 : 1));

// Reads the chosen files and returns them as [{path, bytes, inFolder}], with remarks. `size` is the number of bytes
// that the page already holds.
export const take = async (chosen, size) => {
  if (chosen.length === 0) throw failure(text.nothing);
  let total = size;
  const check = (more) => {
    total += more;
    if (total > MOST) throw failure(text.tooMuch(text.size(total), text.size(MOST)));
  };
  const wanted = [],
    notes = [],
    leftAlone = [];
  for (const one of chosen) {
    const known = RECORD.test(one.path) || /\.(toml|sqlite|zip)$/i.test(one.path);
    if (one.inFolder && !known) leftAlone.push(one.path);
    else wanted.push(one);
  }
  for (const { file } of wanted) check(file.size);
  const files = [];
  for (const { path, file, inFolder } of wanted) {
    const bytes = new Uint8Array(
      await file.arrayBuffer().catch(() => {
        throw failure(text.unreadable(path));
      }),
    );
    if (looksLikeZip(bytes) && !/\.xlsx$/i.test(path)) {
      const unpacked = await readZip(bytes).catch((error) => {
        throw failure(error instanceof TooLarge ? text.bigZip(path) : text.badZip(path));
      });
      // An Excel workbook is also a zip file. A file with this entry is a workbook whose name does not end in .xlsx.
      if (unpacked.some((one) => one.path === '[Content_Types].xml')) files.push({ path: safePath(path), bytes, inFolder });
      else
        for (const one of unpacked) {
          check(one.bytes.length);
          const kept = RECORD.test(one.path) || /\.(toml|sqlite|html|tex)$/i.test(one.path);
          if (kept) files.push({ path: safePath(one.path), bytes: one.bytes, inFolder: true });
        }
    } else files.push({ path: safePath(path), bytes, inFolder });
  }
  if (leftAlone.length > 0) notes.push(text.leftAlone(leftAlone));
  if (files.length === 0 && leftAlone.length === 0) throw failure(text.nothing);
  return { files: files.filter(({ path }) => path !== ''), notes };
};

// If one folder contains all files, removes it from their paths and returns its name as the title.
export function withoutFolder(files) {
  const first = files[0]?.path.split('/')[0];
  if (!files.every(({ path, inFolder }) => inFolder && path.startsWith(first + '/'))) return { files, title: '' };
  const shorter = files.map((one) => ({ ...one, path: one.path.slice(first.length + 1) }));
  const deeper = withoutFolder(shorter);
  return { files: deeper.files, title: deeper.title || first };
}
