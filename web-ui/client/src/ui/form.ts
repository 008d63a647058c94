// A form made from a JSON Schema: one control per member, lists that grow, alternatives by kind. It knows no field by
// name. Every control stands at the JSON pointer that it edits, so that the server's errors find their place.

import { h, type Child } from '../dom';
import { t, type Key } from '../i18n';
import { saveBlob } from '../api';
import { fileName, toCsv } from '../logic/csv';
import { columnsOf, entriesOf, tableOf, TableError } from '../logic/csvList';
import { parseNumber } from '../logic/fields';
import { decode } from '../logic/ownData';
import { join, type Json } from '../logic/pointer';
import { alternative, firstValue, kindOf, meaningAndUnit, rangeOf, referredList, resolve, title } from '../logic/schema';
import { unitText } from '../format';
import type { JsonSchema } from '../types';

export interface FormOptions {
  root: JsonSchema;
  /** The whole document as it stands. */
  document: () => Json;
  /** Called with the new value of a pointer; undefined takes the member out. */
  onChange: (pointer: string, value: Json | undefined) => void;
  /** Shown behind a number: ticks it as a variable of a study, for instance. */
  beside?: (pointer: string, schema: JsonSchema, value: number) => Child;
  /** Pointers of groups that are open at first. */
  open?: Set<string>;
}

type ObjectJson = { [key: string]: Json };
const isObject = (value: Json | undefined): value is ObjectJson => typeof value === 'object' && value !== null && !Array.isArray(value);
/** Thousands of orders are kept, but not shown one by one. */
const mostEntries = 200;
const idOf = (pointer: string) => `f${pointer.replace(/[^\w-]/g, '_')}`;

/** Names that the list `list` of the document gives to its elements. */
function namesIn(document: Json, list: string): string[] {
  const all = isObject(document) ? document[list] : undefined;
  return Array.isArray(all) ? all.flatMap((e) => (isObject(e) && typeof e['name'] === 'string' ? [e['name']] : [])) : [];
}

export class SchemaForm {
  readonly element = h('div', { class: 'schema-form' });
  private readonly open: Set<string>;

  constructor(private readonly options: FormOptions) {
    this.open = options.open ?? new Set();
    this.redraw();
  }

  /** Draws the form anew from the document; open groups and the focus stay. */
  redraw(): void {
    const focused = document.activeElement?.id;
    this.element.replaceChildren(...this.members('', this.options.root, this.options.document()));
    if (focused && this.element.querySelector(`#${CSS.escape(focused)}`)) document.getElementById(focused)?.focus({ preventScroll: true });
  }

  clearErrors(): void {
    for (const place of this.element.querySelectorAll('.field > .bad')) place.textContent = '';
    for (const input of this.element.querySelectorAll('[aria-invalid]')) input.removeAttribute('aria-invalid');
    for (const group of this.element.querySelectorAll('.group.wrong')) group.classList.remove('wrong');
  }

  /** Shows an error at the pointer, or at the nearest group above it. Returns false when it belongs to no place of the form. */
  showError(pointer: string, message: string): boolean {
    const steps = pointer.split('/');
    for (let n = 1; n < steps.length; ++n) this.open.add(steps.slice(0, n + 1).join('/'));
    this.redraw();
    for (let n = steps.length; n > 1; --n) {
      const here = steps.slice(0, n).join('/');
      const field = this.element.querySelector<HTMLElement>(`.field[data-pointer="${CSS.escape(here)}"]`);
      if (field) {
        const place = field.querySelector(':scope > .bad');
        if (place) place.textContent = message;
        field.querySelector('input, select, textarea')?.setAttribute('aria-invalid', 'true');
        field.scrollIntoView({ block: 'nearest' });
        return true;
      }
      const group = this.element.querySelector<HTMLElement>(`.group[data-pointer="${CSS.escape(here)}"]`);
      if (group) {
        group.classList.add('wrong');
        const place = group.querySelector(':scope > .group-error');
        if (place) place.textContent = message;
        group.scrollIntoView({ block: 'nearest' });
        return true;
      }
    }
    return false;
  }

  /** Opens a group and brings it into view. */
  reveal(pointer: string): void {
    const steps = pointer.split('/');
    for (let n = 1; n < steps.length; ++n) this.open.add(steps.slice(0, n + 1).join('/'));
    this.redraw();
    const group = this.element.querySelector<HTMLElement>(`[data-pointer="${CSS.escape(pointer)}"]`);
    group?.scrollIntoView({ block: 'start', behavior: 'auto' });
    group?.querySelector('summary')?.focus({ preventScroll: true });
  }

  private set(pointer: string, value: Json | undefined, redraw = false): void {
    this.options.onChange(pointer, value);
    if (redraw) this.redraw();
  }

  private members(pointer: string, given: JsonSchema, value: Json | undefined): HTMLElement[] {
    const schema = resolve(this.options.root, given);
    const object = isObject(value) ? value : {};
    return Object.entries(schema.properties ?? {})
      .filter(([name, member]) => !name.startsWith('$') && !(name === 'kind' && member.enum?.length === 1))
      .map(([name, member]) => this.member(join(pointer, name), name, member, object[name], schema.required?.includes(name) ?? false));
  }

  private member(pointer: string, name: string, given: JsonSchema, value: Json | undefined, required: boolean): HTMLElement {
    const schema = resolve(this.options.root, given);
    if (schema.oneOf) return this.alternatives(pointer, name, schema, value, required);
    if (schema.type === 'object') return this.object(pointer, name, schema, value, required);
    if (schema.type === 'array') return this.list(pointer, name, schema, value, required);
    return this.field(pointer, name, schema, value, required);
  }

  private group(pointer: string, head: Child, about: string, content: () => Child[], tools: Child = null): HTMLElement {
    const body = h('div', { class: 'group-body' });
    const fill = () => {
      if (body.childNodes.length === 0) body.append(...content().flatMap((c) => (c instanceof Node ? [c] : [])));
    };
    const details = h(
      'details',
      {
        class: 'group',
        'data-pointer': pointer,
        open: this.open.has(pointer),
        ontoggle: () => {
          if (details.open) {
            this.open.add(pointer);
            fill();
          } else this.open.delete(pointer);
        },
      },
      h('summary', {}, head),
      h('p', { class: 'group-error bad', role: 'alert' }),
      about || tools ? h('p', { class: 'about' }, about, ' ', tools) : null,
      body,
    );
    if (this.open.has(pointer)) fill();
    return details;
  }

  private giveOrDrop(pointer: string, schema: JsonSchema, value: Json | undefined, required: boolean): Child {
    if (required) return null;
    return value === undefined || value === null
      ? h('button', { type: 'button', class: 'quiet small', onclick: () => this.set(pointer, this.start(schema), true) }, t('form.give'))
      : h('button', { type: 'button', class: 'quiet small', onclick: () => this.set(pointer, undefined, true) }, t('form.leaveOut'));
  }

  /** What an optional member begins with: its default when that says something, else what it must have. */
  private start(schema: JsonSchema): Json {
    return firstValue(this.options.root, schema);
  }

  private object(pointer: string, name: string, schema: JsonSchema, value: Json | undefined, required: boolean): HTMLElement {
    const { meaning } = meaningAndUnit(schema);
    const given = value !== undefined && value !== null;
    return this.group(
      pointer,
      [title(name), given ? null : h('span', { class: 'muted' }, ` ${t('form.default')}`)],
      meaning,
      () => (given || required ? this.members(pointer, schema, value) : []),
      this.giveOrDrop(pointer, schema, value, required),
    );
  }

  private alternatives(pointer: string, name: string, schema: JsonSchema, value: Json | undefined, required: boolean): HTMLElement {
    const { meaning } = meaningAndUnit(schema);
    const kinds = (schema.oneOf ?? []).map((s) => kindOf(resolve(this.options.root, s)));
    const shown = value === undefined || value === null ? (schema.default as Json | undefined) : value;
    const chosen = alternative(this.options.root, schema, shown);
    const kind = chosen ? kindOf(chosen) : '';
    const id = idOf(`${pointer}/kind`);
    const select = h(
      'select',
      {
        id,
        onchange: () => {
          const next = (schema.oneOf ?? []).map((s) => resolve(this.options.root, s)).find((s) => kindOf(s) === select.value);
          if (!next) return;
          // What both kinds know by the same name is kept.
          const fresh: ObjectJson = { kind: select.value, ...(firstValue(this.options.root, { ...next, default: undefined }) as ObjectJson) };
          const old = isObject(shown) ? shown : {};
          for (const member of Object.keys(fresh)) if (member !== 'kind' && old[member] !== undefined) fresh[member] = old[member];
          fresh['kind'] = select.value;
          this.open.add(pointer);
          this.set(pointer, fresh, true);
        },
      },
      kinds.map((k) => h('option', { value: k, selected: k === kind }, title(k))),
    );
    return this.group(
      pointer,
      [title(name), h('span', { class: 'muted' }, ` ${title(kind)}`)],
      meaning,
      () => [
        h('div', { class: 'field', 'data-pointer': `${pointer}/kind` }, h('label', { for: id }, t('form.kind')), select, h('span', { class: 'about' }), h('span', { class: 'bad', role: 'alert' })),
        ...(chosen ? this.members(pointer, chosen, shown) : []),
      ],
      this.giveOrDrop(pointer, schema, value, required),
    );
  }

  private list(pointer: string, name: string, schema: JsonSchema, value: Json | undefined, required: boolean): HTMLElement {
    const entries = Array.isArray(value) ? value : [];
    const item = resolve(this.options.root, schema.items ?? {});
    const { meaning } = meaningAndUnit(schema);
    const simple = !item.oneOf && item.type !== 'object' && item.type !== 'array';
    const add = (after: Json) => {
      this.open.add(pointer);
      this.set(pointer, [...entries, after], true);
    };
    const blank = (): Json => {
      const list = referredList(this.options.root, { ...item, description: schema.description ?? '' });
      if (list) return namesIn(this.options.document(), list)[0] ?? '';
      const fresh = firstValue(this.options.root, item);
      // Elements are told apart by their names.
      if (isObject(fresh) && typeof fresh['name'] === 'string') {
        const names = new Set(entries.map((e) => (isObject(e) ? e['name'] : '')));
        let k = entries.length + 1;
        while (names.has(`${title(name)} ${k}`)) ++k;
        fresh['name'] = `${title(name)} ${k}`;
      }
      return fresh;
    };
    return this.group(
      pointer,
      [title(name), h('span', { class: 'muted' }, ` ${entries.length}`)],
      meaning,
      () => [
        ...entries.slice(0, mostEntries).map((entry, k) => {
          const here = join(pointer, k);
          const tools = [
            h('button', { type: 'button', class: 'quiet small', onclick: () => add(this.copyOf(entry, entries)) }, t('form.copy')),
            h('button', { type: 'button', class: 'quiet small', 'aria-label': t('form.removeEntry', { name: this.nameOf(entry, k) }), onclick: () => this.set(pointer, entries.filter((_, j) => j !== k), true) }, t('form.remove')),
          ];
          if (simple) {
            const field = this.field(here, `${k + 1}`, { ...item, description: item.description ?? schema.description ?? '' }, entry, true);
            field.append(h('span', { class: 'tools' }, tools[1]));
            return field;
          }
          return this.group(here, this.nameOf(entry, k), '', () => (item.oneOf ? [this.alternatives(here, `${k + 1}`, item, entry, true)] : this.members(here, item, entry)), tools);
        }),
        h('p', {}, h('button', { type: 'button', class: 'quiet small', onclick: () => add(blank()) }, t('form.add', { name: title(name) }))),
        entries.length > mostEntries ? h('p', { class: 'muted' }, t('form.csv.more', { shown: mostEntries, total: entries.length })) : null,
        this.asTable(pointer, name, item, entries),
      ],
      required || entries.length > 0 ? null : null,
    );
  }

  /** A list whose entries are rows of a table is saved as CSV and read from one: orders out of a spreadsheet. */
  private asTable(pointer: string, name: string, item: JsonSchema, entries: readonly Json[]): HTMLElement | null {
    const columns = columnsOf(this.options.root, item);
    if (!columns) return null;
    const note = h('span', { class: 'bad', role: 'alert' });
    const save = (separator: ',' | ';', decimal: '.' | ',') => saveBlob(new Blob([toCsv(tableOf(columns, entries), { separator, decimal })], { type: 'text/csv;charset=utf-8' }), `${fileName(title(name))}.csv`);
    const file = h('input', {
      type: 'file', accept: '.csv,.txt,text/csv', class: 'csv-list', 'aria-label': t('form.csvReadOf', { name: title(name) }),
      onchange: () => {
        const chosen = file.files?.[0];
        if (!chosen) return;
        note.textContent = '';
        void chosen.arrayBuffer().then((bytes) => {
          file.value = ''; // the same file may be chosen again when it has changed
          try {
            const list = entriesOf(columns, decode(bytes).text);
            this.open.add(pointer);
            this.set(pointer, list, true);
          } catch (e) {
            note.textContent = `${chosen.name}: ${e instanceof TableError ? t(`form.csv.${e.key}` as Key, e.values) : String(e)}`;
          }
        });
      },
    });
    return h('p', { class: 'row' },
      h('label', {}, t('form.csvRead'), ' ', file),
      entries.length === 0 ? null : [
        h('button', { type: 'button', class: 'quiet small', onclick: () => save(',', '.') }, t('form.csvSave')),
        h('button', { type: 'button', class: 'quiet small', onclick: () => save(';', ',') }, t('save.excel')),
      ],
      note);
  }

  private nameOf(entry: Json, k: number): string {
    return isObject(entry) && typeof entry['name'] === 'string' && entry['name'] !== '' ? entry['name'] : `${k + 1}`;
  }

  private copyOf(entry: Json, entries: readonly Json[]): Json {
    if (!isObject(entry) || typeof entry['name'] !== 'string') return entry;
    const names = new Set(entries.map((e) => (isObject(e) ? e['name'] : '')));
    let k = 2;
    while (names.has(`${entry['name']} ${k}`)) ++k;
    return { ...entry, name: `${entry['name']} ${k}` };
  }

  private field(pointer: string, name: string, schema: JsonSchema, value: Json | undefined, required: boolean): HTMLElement {
    const id = idOf(pointer);
    const { meaning, unit } = meaningAndUnit(schema);
    const fallback = schema.default === undefined || schema.default === null ? '' : String(schema.default);
    const shown = value === undefined || value === null ? '' : String(value);
    const error = h('span', { class: 'bad', role: 'alert' });
    const common = { id, 'aria-describedby': `${id}-about`, required };
    let control: HTMLElement;
    const list = schema.type === 'string' ? referredList(this.options.root, schema) : undefined;
    if (schema.enum || schema.type === 'boolean' || list) {
      const choices = schema.enum ? schema.enum.map(String) : schema.type === 'boolean' ? ['true', 'false'] : namesIn(this.options.document(), list ?? '');
      const all = shown !== '' && !choices.includes(shown) ? [shown, ...choices] : choices;
      const select = h(
        'select',
        {
          ...common,
          onchange: () => {
            const next = select.value === '' && !required ? undefined : schema.type === 'boolean' ? select.value === 'true' : select.value;
            this.set(pointer, next, true);
          },
        },
        required && shown !== '' ? null : h('option', { value: '', selected: shown === '' }, fallback ? `${title(fallback)} (${t('form.default')})` : '–'),
        all.map((c) => h('option', { value: c, selected: c === shown }, schema.enum ? title(c) : c)),
      );
      control = select;
    } else {
      const number = schema.type === 'number' || schema.type === 'integer';
      const input = h('input', {
        ...common,
        type: 'text',
        value: shown,
        placeholder: fallback,
        autocomplete: 'off',
        inputmode: number ? 'decimal' : 'text',
        onchange: () => {
          error.textContent = '';
          input.removeAttribute('aria-invalid');
          if (!number) return this.set(pointer, input.value === '' && !required ? undefined : input.value, name === 'name');
          if (input.value.trim() === '' && !required) return this.set(pointer, undefined);
          const parsed = parseNumber(input.value);
          if (parsed === null || (schema.type === 'integer' && !Number.isSafeInteger(parsed))) {
            error.textContent = t(schema.type === 'integer' && parsed !== null ? 'models.bad.integer' : 'models.bad.number');
            input.setAttribute('aria-invalid', 'true');
            return;
          }
          this.set(pointer, parsed);
        },
      });
      control = input;
    }
    const range = rangeOf(schema);
    const beside = typeof value === 'number' ? this.options.beside?.(pointer, schema, value) : null;
    return h(
      'div',
      { class: 'field', 'data-pointer': pointer },
      h('label', { for: id }, title(name, unit), unit ? h('span', { class: 'unit' }, ` ${unitText(unit)}`) : null),
      control,
      h('span', { class: 'about', id: `${id}-about` }, meaning, range ? h('span', { class: 'allowed' }, ` (${range})`) : null, beside ? [' ', beside] : null),
      error,
    );
  }
}

