namespace ErrorMatching.Freeform;

/// <summary>Finds measured points that are not what the points around them say: a chip under the stylus, a touch gone wrong.</summary>
/// <remarks>
/// <para>
/// The residual r of a point is its error less what a local fit through its neighbors predicts there (<see cref="NeighborPrediction"/>); over sqrt(1 + leverage) it has the same standard deviation everywhere, if errors are smooth but for noise.
/// That is the deleted residual of regression (Belsley, Kuh and Welsch, Regression Diagnostics, 1980, section 2.1) with a robust scale in its place, 1.4826 times the median of their absolute values (Huber, Robust Statistics, section 5.1).
/// </para>
/// <para>
/// A point is outlying if all of these hold: r is beyond <see cref="Sigmas"/> of those scales, which noise alone reaches once in 10^8; beyond <see cref="LeastMm"/>, for what is less does no harm that a refusal is worth;
/// beyond <see cref="SpreadShare"/> of all that the other points differ, for the residuals at a kink of a smooth field are many scales large, but a small share of the field; and the point stands alone: at most one of its
/// nearest neighbors has about its error. At the two sides of a step there are more, and a step is no touch gone wrong.
/// </para>
/// <para>
/// The most suspicious point is set aside and all others are judged anew, because the neighbors of an outlying point are predicted wrongly with its help, and the spread grows by it; at the end each that was set aside is judged by what is left.
/// </para>
/// </remarks>
internal static class OutlyingPoints
{
    /// <summary>With fewer points too little is known of what lies between them: 5 by 6 points still tell a rim from a chip.</summary>
    public const int LeastPoints = 30;

    /// <summary>Robust standard deviations beyond which a residual is no noise.</summary>
    public const double Sigmas = 6;

    /// <summary>Share of the other points' spread beyond which a residual is no property of a field that they show.</summary>
    public const double SpreadShare = 0.5;

    /// <summary>Residuals below this are let pass, in millimetres.</summary>
    public const double LeastMm = 0.005;

    /// <summary>A neighbor has about the error of a point if they differ by less than this share of the residual.</summary>
    public const double AloneShare = 0.2;

    // If it were more than one point in so many, none could be called an exception.
    private const int OneIn = 10;

    /// <summary>The outlying points in the order of the samples; none if there are fewer than <see cref="LeastPoints"/> samples.</summary>
    /// <param name="samples">Errors on the curves of a grid, each point once.</param>
    public static IReadOnlyList<OutlyingPoint> Of(IReadOnlyList<ErrorSample> samples)
    {
        if (samples.Count < LeastPoints)
        {
            return [];
        }

        var neighbors = new NeighborPrediction(samples);
        var setAside = new List<int>();
        while (setAside.Count < samples.Count / OneIn && Worst(neighbors) is >= 0 and var worst)
        {
            neighbors.SetAside(worst);
            setAside.Add(worst);
        }

        if (setAside.Count == 0)
        {
            return [];
        }

        // The neighbor of two bad points may have looked worse than either.
        while (Cleared(neighbors, setAside) is >= 0 and var cleared)
        {
            neighbors.PutBack(setAside[cleared]);
            setAside.RemoveAt(cleared);
        }

        setAside.Sort();
        return setAside.ConvertAll(k => new OutlyingPoint(samples[k], samples[k].ErrorMm - neighbors.Residuals[k]));
    }

    private static int Worst(NeighborPrediction neighbors)
    {
        var scale = neighbors.Scale();
        var (worst, most) = (-1, 0.0);
        for (var k = 0; k < neighbors.Residuals.Count; k++)
        {
            if (!neighbors.IsAside(k) && Math.Abs(neighbors.Standardized[k]) > most && IsOutlying(neighbors, k, scale))
            {
                (worst, most) = (k, Math.Abs(neighbors.Standardized[k]));
            }
        }

        return worst;
    }

    private static int Cleared(NeighborPrediction neighbors, List<int> setAside)
    {
        var scale = neighbors.Scale();
        return setAside.FindIndex(k => !IsOutlying(neighbors, k, scale));
    }

    // What takes long comes last: hardly any point gets there.
    private static bool IsOutlying(NeighborPrediction neighbors, int k, double scale)
    {
        var size = Math.Abs(neighbors.Residuals[k]);
        return size > LeastMm
            && Math.Abs(neighbors.Standardized[k]) > Sigmas * scale
            && neighbors.SecondNearestError(k) > AloneShare * size
            && size > SpreadShare * neighbors.SpreadWithout(k);
    }
}
