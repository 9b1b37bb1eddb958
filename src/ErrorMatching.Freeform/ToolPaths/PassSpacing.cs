namespace ErrorMatching.Freeform;

/// <summary>Predicts the distance to the next pass from the surface along the current pass and the heights of previous strips.</summary>
internal sealed class PassSpacing(OffsetSurface offset, double scallopMm)
{
    private const int Samples = 48;

    // Rather somewhat closer than to be made twice.
    private const double Aim = 0.95;

    private double _ridge;
    private double _factor = 0.9;

    /// <summary>Distance to the next pass, in the parameter.</summary>
    public double From(CutPass pass)
    {
        _ridge = 0;
        foreach (var line in pass.Lines)
        {
            var stride = Math.Max(1, line.Count / Samples);
            for (var i = 0; i < line.Count; i += stride)
            {
                _ridge = Math.Max(_ridge, RidgeAt(line.Places[i].X, pass.V));
            }
        }

        if (_ridge <= 0)
        {
            var (u, v) = (offset.Surface.Spline.KnotsU, offset.Surface.Spline.KnotsV);
            for (var i = 0; i <= Samples; i++)
            {
                _ridge = Math.Max(_ridge, RidgeAt(u.Start + ((u.End - u.Start) * i / Samples), pass.V));
            }

            _ridge = Math.Max(_ridge, 1e-12 * scallopMm / ((v.End - v.Start) * (v.End - v.Start)));
        }

        return _factor * Math.Sqrt(scallopMm / _ridge);
    }

    /// <summary>Learns from the height of a strip.</summary>
    public void Learn(double width, double heightMm)
    {
        if (heightMm > 0 && _ridge > 0)
        {
            _factor = Math.Clamp(width / Math.Sqrt(scallopMm / _ridge) * Math.Sqrt(Aim * scallopMm / heightMm), 0.05, 1.2);
        }
    }

    // Height of the ridge of a strip with a width of one parameter unit.
    private double RidgeAt(double u, double v)
    {
        var at = offset.Surface.Spline.At(u, v);
        var (e, f) = (at.Du.Dot(at.Du), at.Du.Dot(at.Dv));
        if (!(e > 0))
        {
            return 0;
        }

        var back = -f / e;
        var across = (at.Dv + (at.Du * back)).Length;
        var convex = -offset.Surface.Outside * at.NormalCurvature(back, 1);
        var stretched = 1 + (offset.StockMm * convex);
        var width = across * stretched;
        var ridge = width * width * ((1 / offset.RadiusMm) + (convex / stretched)) / 8;
        return double.IsFinite(ridge) ? ridge : 0;
    }
}
