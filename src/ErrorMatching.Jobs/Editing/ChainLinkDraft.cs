namespace ErrorMatching.Jobs;

/// <summary>A dimension of the tolerance chain, as typed.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Nominal">Its nominal value, mm.</param>
/// <param name="Lower">Its lower limit, mm.</param>
/// <param name="Upper">Its upper limit, mm.</param>
/// <param name="Sign"><c>1</c> if a larger dimension lengthens the chain, <c>-1</c> if it shortens it.</param>
public sealed record ChainLinkDraft(string Name = "", string Nominal = "", string Lower = "", string Upper = "", string Sign = "1");
