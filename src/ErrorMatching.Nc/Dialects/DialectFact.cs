namespace ErrorMatching.Nc;

/// <summary>One statement of a dialect about its control, with its source: a row of the manual page.</summary>
/// <param name="Topic">Its topic.</param>
/// <param name="Subject">Its subject, as in the dialect's file: codes, letters, the name of a setting.</param>
/// <param name="Meaning">Its meaning for the interpreter, as in the dialect's file (<c>work-offset</c>, <c>axis</c>, <c>true</c>); empty
/// if there is only the statement.</param>
/// <param name="Statement">The fact, in a sentence.</param>
/// <param name="Source">The manual or standard, a measurement, or the word <c>assumed</c>.</param>
/// <param name="Dialect">Name of the dialect whose file states it: the dialect itself, or one that it continues.</param>
public sealed record DialectFact(DialectTopic Topic, string Subject, string Meaning, string Statement, string Source, string Dialect);
