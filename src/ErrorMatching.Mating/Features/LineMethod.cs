namespace ErrorMatching.Mating;

/// <summary>How a straight line is fitted to more than two points.</summary>
public enum LineMethod
{
    /// <summary>Total least squares: perpendicular residuals.</summary>
    Total,

    /// <summary>Ordinary least squares: residuals along the second axis of the plane (equation 4 of Wang 2021).</summary>
    Ordinary,
}
