namespace ErrorMatching.Freeform;

/// <summary>Finds measured points that contradict their neighbors, such as a chip under the stylus or a bad touch.</summary>
/// <remarks>
/// <para>
/// The residual r of a point is its error minus the prediction of a local fit through its neighbors (<see cref="NeighborPrediction"/>).
/// Divided by sqrt(1 + leverage), it has the same standard deviation everywhere if errors are smooth except for noise.
/// This is the deleted residual of regression (Belsley, Kuh and Welsch, Regression Diagnostics, 1980, section 2.1) with a robust scale:
/// 1.4826 times the median of the absolute values (Huber, Robust Statistics, section 5.1).
/// </para>
/// <para>
/// A point is outlying if all of these conditions are met. The residual r exceeds <see cref="Sigmas"/> scales, which noise alone reaches
/// once in 10^8. It exceeds <see cref="LeastMm"/>, below which the harm does not justify a refusal.
/// It exceeds <see cref="SpreadShare"/> of the spread of the other points, because residuals at a kink of a smooth field are many scales
/// large but a small share of the field. And the point is isolated:
/// at most one of its nearest neighbors has about the same error. At a step there are more, and a step is not a bad touch.
/// </para>
/// <para>
/// The most suspicious point is set aside and all others are judged again, because an outlying point distorts the predictions of its
/// neighbors and the spread. Finally, each point that was set aside is judged by the remaining ones.
/// </para>
/// </remarks>
internal static class OutlyingPoints
{
    /// <summary>Robust standard deviations beyond which a residual is not noise.</summary>
    public const double Sigmas = 6;

    /// <summary>Share of the other points' spread beyond which a residual does not belong to their field.</summary>
    public const double SpreadShare = 0.5;

    /// <summary>Smaller residuals are accepted, in millimeters.</summary>
    public const double LeastMm = 0.005;

    /// <summary>A neighbor has about the same error if the difference is less than this share of the residual.</summary>
    public const double AloneShare = 0.2;

    // At most one point in this many may be outlying. With more, none would be an exception.
    private const int OneIn = 10;

    /// <summary>Returns the outlying points in sample order.</summary>
    /// <param name="samples">Errors on the curves of a grid, each point once. Of a few, <see cref="FewPoints"/> judges.</param>
    /// <param name="uncertaintyMm">Standard uncertainty of one of them.</param>
    public static IReadOnlyList<OutlyingPoint> Find(IReadOnlyList<ErrorSample> samples, double uncertaintyMm)
    {
        if (samples.Count < FewPoints.Enough)
        {
            return FewPoints.Outlying(samples, uncertaintyMm);
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

    // The slow checks come last, because few points reach them.
    private static bool IsOutlying(NeighborPrediction neighbors, int k, double scale)
    {
        var size = Math.Abs(neighbors.Residuals[k]);
        return size > LeastMm
            && Math.Abs(neighbors.Standardized[k]) > Sigmas * scale
            && neighbors.SecondNearestError(k) > AloneShare * size
            && size > SpreadShare * neighbors.SpreadWithout(k);
    }
}
