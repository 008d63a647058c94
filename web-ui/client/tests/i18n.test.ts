import { describe, expect, it } from 'vitest';
import { dictionaries, named, setLanguage, t } from '../src/i18n';

const placeholders = (text: string) => [...text.matchAll(/\{(\w+)\}/g)].map((m) => m[1]).sort();

describe('translations', () => {
  it('are complete: the same keys in both languages, no empty text', () => {
    expect(Object.keys(dictionaries.uk).sort()).toEqual(Object.keys(dictionaries.en).sort());
    for (const texts of Object.values(dictionaries)) for (const text of Object.values(texts)) expect(text.trim()).not.toBe('');
  });
  it('use the same placeholders', () => {
    for (const key of Object.keys(dictionaries.en) as (keyof typeof dictionaries.en)[])
      expect(placeholders(dictionaries.uk[key]), key).toEqual(placeholders(dictionaries.en[key]));
  });
  it('are translated: no English sentence is left in Ukrainian', () => {
    for (const [key, text] of Object.entries(dictionaries.uk))
      if (/[a-z]{3,} [a-z]{3,} [a-z]{3,}/i.test(text.replace(/`[^`]*`/g, ''))) expect.fail(`${key}: ${text}`);
  });
  it('fill in placeholders and keep unknown ones visible', () => {
    setLanguage('en');
    expect(t('run.title', { id: 7 })).toBe('Run 7');
    expect(t('run.title')).toBe('Run {id}');
  });
  it('name data they know and let through data they do not', () => {
    expect(named('state', 'waiting_crew')).toBe('waiting for the crew');
    expect(named('state', 'spindle_warm_up')).toBe('spindle warm up');
  });
});
