namespace ErrorMatching.Jobs;

/// <summary>A named contribution to the gauge's uncertainty, as typed.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Value">Its standard uncertainty, mm.</param>
public sealed record ContributionDraft(string Name = "", string Value = "");
