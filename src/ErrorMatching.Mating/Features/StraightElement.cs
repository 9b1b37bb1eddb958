namespace ErrorMatching.Mating;

/// <summary>A straight element of a feature, whose direction a job may compare.</summary>
/// <param name="Points">The labels of its key points in the order of cutting.</param>
/// <param name="Method">How a line is fitted to them.</param>
internal sealed record StraightElement(IReadOnlyList<string> Points, LineMethod Method);

/// <summary>How a straight line is fitted to more than two points.</summary>
internal enum LineMethod
{
    /// <summary>Total least squares: perpendicular residuals.</summary>
    Total,

    /// <summary>Ordinary least squares: residuals along the second axis of the plane (equation 4 of Wang 2021).</summary>
    Ordinary,
}
