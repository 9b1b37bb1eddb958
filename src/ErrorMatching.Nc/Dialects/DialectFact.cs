namespace ErrorMatching.Nc;

/// <summary>One statement of a dialect about its control, with where it comes from: a row of the manual page.</summary>
/// <param name="Topic">What kind of thing it is about.</param>
/// <param name="Subject">What it is about, as in the dialect's file: codes, letters, the name of a setting.</param>
/// <param name="Meaning">What it means to the interpreter, as in the dialect's file (<c>work-offset</c>, <c>axis</c>, <c>true</c>); empty
/// where the statement is all there is.</param>
/// <param name="Statement">What holds, in a sentence.</param>
/// <param name="Source">The manual or standard, a measurement, or the word <c>assumed</c>.</param>
/// <param name="Dialect">Name of the dialect whose file states it: the dialect itself, or one that it continues.</param>
public sealed record DialectFact(DialectTopic Topic, string Subject, string Meaning, string Statement, string Source, string Dialect);
