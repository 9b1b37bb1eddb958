namespace ErrorMatching.Freeform;

/// <summary>The figures of a finished path.</summary>
internal sealed record ToolPathPlan(
    int Passes, int Points, double LengthMm, double TravelCenterZ, ToolPathCertificate Certificate, int Decimals);
