using System.Globalization;

namespace ErrorMatching.Mating;

/// <summary>The terms of equation (7) of Wang 2021, which estimates the measuring time.</summary>
/// <param name="ProbingSpeedMmPerS">Probing speed.</param>
/// <param name="ProbingDistanceMm">Distance between the probe and a key point before the touch.</param>
/// <param name="CalculatingS">Time to calculate the deviations.</param>
/// <param name="Touches">Number of points that the gauge touches; null if it is the number of key points.</param>
public sealed record MeasuringTime(double ProbingSpeedMmPerS, double ProbingDistanceMm, double CalculatingS, int? Touches = null)
{
    /// <summary>The paper's values: 10 mm/s, 5 mm, 1 s.</summary>
    public static MeasuringTime Default { get; } = new(10, 5, 1);

    /// <summary>Equation (7): number of touched points times distance divided by speed, plus the calculation time.</summary>
    /// <param name="keyPoints">Number of key points, zero or more.</param>
    /// <exception cref="ArgumentOutOfRangeException">The number is negative.</exception>
    public double TotalS(int keyPoints)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(keyPoints);
        return ((Touches ?? keyPoints) * ProbingDistanceMm / ProbingSpeedMmPerS) + CalculatingS;
    }

    /// <inheritdoc/>
    public override string ToString() => string.Create(
        CultureInfo.InvariantCulture, $"{ProbingDistanceMm} mm at {ProbingSpeedMmPerS} mm/s a point, {CalculatingS} s of calculation");
}
