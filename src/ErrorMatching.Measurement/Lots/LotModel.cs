using ErrorMatching.Geometry;

namespace ErrorMatching.Measurement;

/// <summary>An assumption about the error of a process from piece to piece. The error drifts at a constant rate and walks at random; a
/// measured value adds noise. Variances in mm^2.</summary>
/// <param name="Noise">Variance of a measured value about the error of the process.</param>
/// <param name="Start">Variance of the error at the first piece.</param>
/// <param name="Walk">Variance of its random change from piece to piece.</param>
/// <param name="Drift">Variance of its constant change from piece to piece.</param>
/// <param name="LogPrior">Logarithm of the probability of the assumption before anything is measured.</param>
internal readonly record struct LotModel(double Noise, double Start, double Walk, double Drift, double LogPrior)
{
    // Variances in squares of the uncertainty of a value, with their prior probabilities. A process in order is the likeliest: no error, no
    // walk, no drift. The first start is small instead of zero, so that it can be divided by.
    private static readonly (double Square, double Probability)[] _noise = [(0, 0.4), (0.1, 0.15), (1, 0.2), (4, 0.15), (16, 0.1)];
    private static readonly (double Square, double Probability)[] _start =
        [(0.001, 0.6), (1, 0.08), (4, 0.08), (16, 0.08), (100, 0.08), (1600, 0.08)];

    private static readonly (double Square, double Probability)[] _walk = [(0, 0.9), (0.01, 0.033), (0.1, 0.033), (1, 0.034)];
    private static readonly (double Square, double Probability)[] _drift = [(0, 0.79), (0.001, 0.07), (0.02, 0.07), (0.4, 0.07)];

    /// <summary>All assumptions that are compared.</summary>
    /// <param name="uncertaintyMm">Standard uncertainty of one measured point.</param>
    /// <param name="leastNoise">The part of it that stays in a value, squared: less for a mean of points.</param>
    public static LotModel[] All(double uncertaintyMm, double leastNoise)
    {
        var unit = uncertaintyMm * uncertaintyMm;
        return
        [
            .. from noise in _noise
               from start in _start
               from walk in _walk
               from drift in _drift
               select new LotModel(
                   leastNoise + (noise.Square * unit),
                   start.Square * unit,
                   walk.Square * unit,
                   drift.Square * unit,
                   Elementary.Log(noise.Probability * start.Probability * walk.Probability * drift.Probability))];
    }
}
