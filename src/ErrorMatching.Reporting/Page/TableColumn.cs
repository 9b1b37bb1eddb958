namespace ErrorMatching.Reporting;

/// <summary>The head of a column.</summary>
/// <param name="Title">What stands in it, with the unit.</param>
/// <param name="IsNumber">True if its cells are aligned at the decimal sign.</param>
/// <param name="Group">A common head over neighboring columns; null if it has none.</param>
public sealed record TableColumn(string Title, bool IsNumber = false, string? Group = null);
