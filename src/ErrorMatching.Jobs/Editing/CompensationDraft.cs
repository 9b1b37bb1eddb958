namespace ErrorMatching.Jobs;

/// <summary>What is made of the deviations, as it is being typed. What is empty is the job's default.</summary>
/// <param name="From"><c>part</c> or <c>counterpart</c>.</param>
/// <param name="Gain">How much of a deviation is compensated.</param>
/// <param name="Amount"><c>whole</c> or <c>excess</c>.</param>
/// <param name="Along"><c>normal</c> or <c>vector</c>.</param>
/// <param name="Limit">A larger deviation stops the job, mm.</param>
public sealed record CompensationDraft(
    string From = "part", string Gain = "", string Amount = "whole", string Along = "normal", string Limit = "");
