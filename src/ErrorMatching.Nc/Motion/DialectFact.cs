namespace ErrorMatching.Nc;

/// <summary>One statement of a dialect about its control, with where it comes from.</summary>
/// <param name="Topic">What it is about: a code, a letter, an increment.</param>
/// <param name="Statement">What holds.</param>
/// <param name="Source">The manual or standard, or the word <c>assumed</c>.</param>
public sealed record DialectFact(string Topic, string Statement, string Source);
