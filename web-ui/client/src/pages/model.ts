// One function: where it comes from, a form for its inputs, what it gives.

import { api, ApiError } from '../api';
import { fragment, h, table, type Child } from '../dom';
import { significant, unitText } from '../format';
import { t } from '../i18n';
import { FieldError, provenanceKind, rangeText, readField, writeField } from '../logic/fields';
import { section, type PageMaker } from '../page';
import type { Field, ModelFunction } from '../types';

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
          h('span', { class: 'about', id: `about-${field.name}` }, field.meaning, allowed ? h('span', { class: 'allowed' }, ` (${allowed})`) : null),
          error,
        );
      }),
    );
  };
  fill(f.example.inputs);

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
    ),
  };
};
