namespace ErrorMatching.Reporting;

/// <summary>The heading of a column.</summary>
/// <param name="Title">The heading, with the unit.</param>
/// <param name="IsNumber">True if its cells are aligned at the decimal point.</param>
/// <param name="Group">A common heading of neighboring columns; null if there is none.</param>
public sealed record TableColumn(string Title, bool IsNumber = false, string? Group = null);
