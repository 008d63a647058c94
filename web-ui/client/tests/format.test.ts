import { afterEach, describe, expect, it } from 'vitest';
import { decimalsFor, estimate, estimateText, fixed, significant, unitText } from '../src/format';
import { setLanguage } from '../src/i18n';

afterEach(() => setLanguage('en'));

describe('numbers', () => {
  it('what rounds to nought has no sign', () => {
    expect([fixed(-0.04, 1), fixed(-0, 2), fixed(-0.06, 1)]).toEqual(['0.0', '0.00', '-0.1']);
  });
  it('shows two digits of the uncertainty and the mean no finer', () => {
    expect(estimateText(149.72325817975917, 0.4281050065366141)).toBe('149.72 ± 0.43');
    expect(estimateText(13929.8, 16.00322587259135)).toBe('13,930 ± 16');
    expect(estimateText(0.7639006121494948, 0.00088528200107066, 100)).toBe('76.390 ± 0.089');
    expect(decimalsFor(0.0012)).toBe(4);
  });
  it('shows a mean without uncertainty with six digits, and a missing one as a dash', () => {
    expect(estimate(12.3456789, null)).toEqual({ mean: '12.3457', half: '' });
    expect(estimate(0, 0)).toEqual({ mean: '0', half: '' });
    expect(estimateText(null, null)).toBe('–');
  });
  it('uses the decimal comma in Ukrainian', () => {
    setLanguage('uk');
    expect(fixed(3.5, 1)).toBe('3,5');
    expect(estimateText(149.72325817975917, 0.4281050065366141)).toBe('149,72 ± 0,43');
  });
  it('prints very small and very large numbers with an exponent and no minus nought', () => {
    expect(significant(1.5e-7)).toBe('1.5·10^-7');
    expect(significant(2e12)).toBe('2·10^12');
    expect(fixed(-0, 1)).toBe('0.0');
  });
  it('prints no unit for plain numbers', () => {
    expect(unitText('1')).toBe('');
    expect(unitText('mm^2')).toBe('mm²');
    expect(unitText('m/min')).toBe('m/min');
  });
  it('a half-width that is rounding noise is none', () => {
    expect(estimateText(33.442993796469, 1e-14)).toBe('33.443');
    expect(estimateText(0, 0)).toBe('0');
  });
});
