namespace ErrorMatching.Jobs;

/// <summary>How deviations are compensated, as typed. An empty field means the job's default.</summary>
/// <param name="From"><c>part</c> or <c>counterpart</c>.</param>
/// <param name="Gain">Fraction of a deviation to compensate.</param>
/// <param name="Amount"><c>whole</c> or <c>excess</c>.</param>
/// <param name="Along"><c>normal</c> or <c>vector</c>.</param>
/// <param name="Limit">A larger deviation stops the job, mm.</param>
public sealed record CompensationDraft(
    string From = "part", string Gain = "", string Amount = "whole", string Along = "normal", string Limit = "");
