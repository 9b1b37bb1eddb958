namespace ErrorMatching.Reporting;

/// <summary>A section of a page.</summary>
/// <param name="Id">Its identifier, for links.</param>
/// <param name="Title">Its heading.</param>
/// <param name="Write">Writes the content below the heading.</param>
public sealed record PageSection(string Id, string Title, Action<HtmlText> Write);
