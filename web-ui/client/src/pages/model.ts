// One function: where it comes from, a form for its inputs, what it gives.

import { api, ApiError } from '../api';
import { fragment, h, table, type Child } from '../dom';
import { significant, unitText } from '../format';
import { t } from '../i18n';
import { chart } from '../charts/chart';
import { curveOption, mapOption } from '../charts/modelMap';
import { FieldError, parseNumber, provenanceKind, rangeText, readField, sliderRange, spread, writeField } from '../logic/fields';
import { title } from '../logic/schema';
import { section, type PageContext, type PageMaker } from '../page';
import type { Field, ModelFunction, ModelMap } from '../types';

type Control = HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement;

function control(field: Field, value: unknown): Control {
  const id = `in-${field.name}`;
  const common = { id, name: field.name, 'aria-describedby': `about-${field.name} error-${field.name}`, required: field.required === true };
  const options = field.kind === 'flag' ? ['true', 'false'] : (field.choices ?? []);
  if (field.kind === 'choice' || field.kind === 'flag') {
    const chosen = value === undefined || value === null ? '' : String(value);
    return h(
      'select',
      common,
      field.required ? null : h('option', { value: '', selected: chosen === '' }, `${t('models.choose')} (${String(field.default)})`),
      options.map((o) => h('option', { value: o, selected: o === chosen }, o)),
    );
  }
  const text = writeField(field, value);
  const placeholder = field.required || field.default === null || field.default === undefined ? '' : writeField(field, field.default);
  if (field.kind === 'number' || field.kind === 'integer' || field.kind === 'text')
    return h('input', { ...common, type: 'text', value: text, placeholder, autocomplete: 'off', inputmode: field.kind === 'text' ? 'text' : 'decimal' });
  return h('textarea', { ...common, rows: text.length > 60 ? 4 : 2, placeholder, spellcheck: 'false' }, text);
}

function cell(value: unknown): Child {
  if (value === null || value === undefined) return '–';
  if (typeof value === 'number') return significant(value, 8);
  if (typeof value === 'boolean') return value ? t('yes') : t('no');
  if (typeof value === 'string') return value;
  return h('code', {}, JSON.stringify(value));
}

/** A slider beside a number, over its range or about its example. */
function slider(field: Field, input: HTMLInputElement, moved: () => void): Child {
  if (field.kind !== 'number' && field.kind !== 'integer') return null;
  const value = parseNumber(input.value) ?? parseNumber(input.placeholder);
  if (value === null) return null;
  const { low, high } = sliderRange(field, value);
  const range = h('input', { type: 'range', min: low, max: high, step: field.kind === 'integer' ? 1 : 'any', value, class: 'slider', 'aria-label': t('plan.move', { name: field.name }), oninput: () => {
    input.value = field.kind === 'integer' ? range.value : String(Number(Number(range.value).toPrecision(4)));
    moved();
  } });
  input.addEventListener('change', () => { const typed = parseNumber(input.value); if (typed !== null) range.value = String(typed); });
  return range;
}

const curvePoints = 101;
const mapPoints = 41;

/** One output along one input, or over two. */
function mapSection(context: PageContext, f: ModelFunction, inputsNow: () => Record<string, unknown> | null): HTMLElement | null {
  const free = f.inputs.filter((i) => (i.kind === 'number' || i.kind === 'integer') && typeof (f.example.inputs[i.name] ?? i.default) === 'number');
  const outputs = f.outputs.filter((o) => o.kind === 'number' || o.kind === 'integer');
  const [first] = free;
  if (!first || outputs.length === 0) return null;
  const place = h('div', { id: 'model-map' });
  const note = h('p', { class: 'muted', role: 'status' });
  const select = (id: string, label: string, options: [string, string][], chosen: string) => {
    const element = h('select', { id, onchange: () => setRange(id) }, options.map(([value, text]) => h('option', { value, selected: value === chosen }, text)));
    return { element, row: [h('label', { for: id }, label), element] };
  };
  const names = free.map((i): [string, string] => [i.name, i.name]);
  const x = select('map-x', t('map.x'), names, first.name);
  const y = select('map-y', t('map.y'), [['', t('map.none')], ...names], '');
  const z = select('map-z', t('map.output'), outputs.map((o) => [o.name, o.name]), outputs[0]?.name ?? '');
  const low = h('input', { id: 'map-low', type: 'text', inputmode: 'decimal', size: 8 });
  const high = h('input', { id: 'map-high', type: 'text', inputmode: 'decimal', size: 8 });
  const valueOf = (name: string): number => {
    const now = inputsNow()?.[name] ?? f.example.inputs[name] ?? f.inputs.find((i) => i.name === name)?.default;
    return typeof now === 'number' ? now : 1;
  };
  const setRange = (changed: string) => {
    const field = free.find((i) => i.name === x.element.value) ?? first;
    if (changed === 'map-x') {
      const range = sliderRange(field, valueOf(field.name));
      low.value = String(range.low);
      high.value = String(range.high);
    }
    if (place.childNodes.length > 0) void draw();
  };
  const hidden: (() => void)[] = [];
  const clear = () => hidden.splice(0).forEach((clean) => clean());
  context.whenLeft(clear);
  const draw = async () => {
    const inputs = inputsNow();
    const [from, to] = [parseNumber(low.value), parseNumber(high.value)];
    const field = free.find((i) => i.name === x.element.value);
    const second = free.find((i) => i.name === y.element.value);
    const output = outputs.find((o) => o.name === z.element.value);
    if (!inputs || !field || !output || from === null || to === null || !(to > from) || second === field) {
      note.textContent = t('map.bad');
      return;
    }
    note.textContent = t('page.loading');
    const xs = spread(from, to, second ? mapPoints : curvePoints, field.kind === 'integer');
    const about = second ? sliderRange(second, valueOf(second.name)) : { low: 0, high: 0 };
    const ys = second ? spread(about.low, about.high, mapPoints, second.kind === 'integer') : [];
    let map: ModelMap;
    try {
      map = await api.map(f.key, { inputs, output: output.name, x: { name: field.name, values: xs }, ...(second ? { y: { name: second.name, values: ys } } : {}) }, context.signal);
    } catch (e) {
      if (!context.signal.aborted) note.textContent = e instanceof ApiError && e.message ? e.message : t('state.offline');
      return;
    }
    clear();
    const drawers: (() => void)[] = [];
    const inner: PageContext = { signal: context.signal, whenShown: (d) => drawers.push(d), whenLeft: (c) => hidden.push(c) };
    const unit = (g: Field) => (unitText(g.unit) ? `${g.name}, ${unitText(g.unit)}` : g.name);
    const label = t('map.label', { z: output.name, x: field.name });
    const picture = second
      ? chart(inner, label, 'tall', (theme) => mapOption(xs, ys, map.values, unit(field), unit(second), unit(output), theme), { name: `${f.key}-${output.name}`, data: () => [[`${second.name} \\ ${field.name}`, ...xs], ...ys.map((v, k) => [v, ...(map.values[k] ?? [])])] })
      : chart(inner, label, 'medium', (theme) => curveOption(xs, map.values[0] ?? [], unit(field), unit(output), valueOf(field.name), theme), { name: `${f.key}-${output.name}`, data: () => [[field.name, output.name], ...xs.map((v, k) => [v, map.values[0]?.[k] ?? null])] });
    place.replaceChildren(picture.element);
    drawers.forEach((d) => d());
    const refused = Object.values(map.refusals);
    note.textContent = refused.length > 0 ? `${t('map.gaps')} ${refused.join('; ')}` : '';
  };
  setRange('map-x');
  return section(
    t('map.title'),
    '',
    h('p', { class: 'row no-print' }, z.row, x.row, h('label', { for: 'map-low' }, t('map.from')), low, h('label', { for: 'map-high' }, t('map.to')), high, y.row, h('button', { type: 'button', id: 'map-draw', onclick: () => void draw() }, t('map.draw'))),
    place,
    note,
  );
}

function outputTable(f: ModelFunction, outputs: Record<string, unknown>): HTMLElement {
  return table<Field>(
    t('models.outputs'),
    [
      { head: t('col.name'), rowHead: true, cell: (o) => h('code', {}, o.name) },
      { head: t('col.value'), number: true, cell: (o) => h('output', { 'data-output': o.name }, cell(outputs[o.name])) },
      { head: t('col.unit'), cell: (o) => h('span', { class: 'unit' }, unitText(o.unit)) },
      { head: t('col.meaning'), cell: (o) => h('span', { class: 'muted' }, o.meaning) },
    ],
    f.outputs,
  );
}

function provenanceText(provenance: string): string {
  const kind = provenanceKind(provenance);
  return kind ? t(`prov.${kind}`) : provenance;
}

export const modelPage: PageMaker = async (context, [key = '']) => {
  const f = await api.model(key, context.signal);
  const controls = new Map<string, Control>();
  const errors = new Map<string, HTMLElement>();
  const results = h('div', { id: 'results' }, outputTable(f, f.example.outputs));
  const note = h('p', { class: 'muted', role: 'status', id: 'model-note' });
  const fields = h('div', { class: 'fields' });

  const fill = (inputs: Record<string, unknown>) => {
    controls.clear();
    errors.clear();
    fields.replaceChildren(
      ...f.inputs.map((field) => {
        const input = control(field, inputs[field.name]);
        const error = h('span', { class: 'bad', id: `error-${field.name}`, role: 'alert' });
        controls.set(field.name, input);
        errors.set(field.name, error);
        const allowed = [rangeText(field), field.required ? t('models.required') : field.default !== null && field.default !== undefined ? t('models.default', { value: writeField(field, field.default) }) : '']
          .filter(Boolean)
          .join('; ');
        return h(
          'div',
          { class: 'field' },
          h('label', { for: input.id }, h('code', {}, field.name), h('span', { class: 'unit' }, ' ', unitText(field.unit))),
          input,
          slider(field, input as HTMLInputElement, () => { form.dispatchEvent(new Event('input')); evaluateSoon(); }),
          h('span', { class: 'about', id: `about-${field.name}` }, field.meaning, allowed ? h('span', { class: 'allowed' }, ` (${allowed})`) : null),
          error,
        );
      }),
    );
  };
  let timer = 0;
  context.whenLeft(() => clearTimeout(timer));
  const evaluateSoon = () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => void evaluate(), 60);
  };

  const evaluate = async () => {
    for (const e of errors.values()) e.textContent = '';
    for (const c of controls.values()) c.removeAttribute('aria-invalid');
    const blame = (name: string, words: string) => {
      // Errors inside a structure name a path: "cam/r_base_mm".
      const top = name.split('/')[0] ?? '';
      const place = errors.get(top);
      if (place) place.textContent = words;
      else note.textContent = words;
      const input = controls.get(top);
      input?.setAttribute('aria-invalid', 'true');
      input?.focus();
    };
    const inputs: Record<string, unknown> = {};
    try {
      for (const field of f.inputs) {
        const value = readField(field, controls.get(field.name)?.value ?? '');
        if (value !== undefined) inputs[field.name] = value;
      }
    } catch (e) {
      if (e instanceof FieldError) return blame(e.field, t(`models.bad.${e.reason}`));
      throw e;
    }
    try {
      results.replaceChildren(outputTable(f, await api.evaluate(f.key, inputs)));
      results.classList.remove('stale');
      note.textContent = t('models.done');
    } catch (e) {
      if (e instanceof ApiError) blame(e.input, e.message || t('state.offline'));
      else throw e;
    }
  };

  const form = h(
    'form',
    {
      novalidate: true,
      onsubmit: (event: Event) => {
        event.preventDefault();
        void evaluate();
      },
      oninput: () => {
        results.classList.add('stale');
        note.textContent = t('models.stale');
      },
    },
    fields,
    h(
      'p',
      { class: 'row sticky' },
      h('button', { type: 'submit', class: 'primary' }, t('models.evaluate')),
      h('button', { type: 'button', class: 'quiet', onclick: () => { fill(f.example.inputs); void evaluate(); } }, t('models.reset')),
      note,
    ),
  );
  fill(f.example.inputs);
  /** The form's inputs as they stand; null when one of them cannot be read. */
  const inputsNow = (): Record<string, unknown> | null => {
    try {
      return Object.fromEntries(f.inputs.flatMap((field) => { const v = readField(field, controls.get(field.name)?.value ?? ''); return v === undefined ? [] : [[field.name, v]]; }));
    } catch {
      return null;
    }
  };
  const users = (await api.kinds(context.signal)).kinds.filter((k) => k.sources.includes(f.source.id));
  return {
    title: f.key,
    body: fragment(
      h('h1', {}, f.key, h('span', { class: 'unit' }, ` ${f.role}`)),
      h('p', { class: 'words' }, f.summary),
      h(
        'p',
        { class: 'facts' },
        h('span', { class: `flag ${provenanceKind(f.provenance) ?? ''}` }, f.provenance),
        ` ${provenanceText(f.provenance)}. `,
        h('span', { class: 'muted' }, `${f.source.id}, ${f.equation}: ${[f.source.authors, f.source.title, f.source.published].map((s) => s.replace(/\.$/, '')).join('. ')}.`),
      ),
      h('div', { class: 'columns' }, section(t('models.inputs'), '', form), section(t('models.outputs'), '', results, f.notes.length > 0 ? [h('h3', {}, t('models.notes')), h('ul', {}, f.notes.map((n) => h('li', {}, n)))] : null)),
      mapSection(context, f, inputsNow),
      section(t('models.use'), '', users.length > 0 ? h('ul', {}, users.map((k) => h('li', {}, h('a', { href: `#/operations/${k.name}` }, title(k.name)), `: ${k.summary}`))) : h('p', { class: 'muted' }, t('models.noUse'))),
    ),
  };
};
