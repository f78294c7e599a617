// SPDX-License-Identifier: GPL-3.0-or-later
/** Made by build.mjs. */
declare module 'page:formulas' {
  /** MathML by case */
  const formulas: Record<string, string>;
  export default formulas;
}
declare module 'page:licences' {
  /** of what is bundled */
  const licences: { name: string; version: string; text: string }[];
  export default licences;
}
declare module '*.css';
