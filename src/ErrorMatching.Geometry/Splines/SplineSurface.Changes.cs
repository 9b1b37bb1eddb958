namespace ErrorMatching.Geometry;

/// <content>Other representations of the same surface: other knots, higher degrees, a part, reversed.</content>
public sealed partial class SplineSurface
{
    /// <summary>Converts surfaces to <see cref="KnotVector.Common"/> knots in both directions, so that poles with the same index can be
    /// added. The surfaces do not move.</summary>
    /// <remarks>Ranges and knots are handled as in <see cref="SplineCurve.Compatible"/>.</remarks>
    /// <param name="surfaces">At least one.</param>
    /// <exception cref="GeometryException">The list is empty.</exception>
    public static IReadOnlyList<SplineSurface> Compatible(IReadOnlyList<SplineSurface> surfaces)
    {
        ArgumentNullException.ThrowIfNull(surfaces);
        var u = KnotVector.Common([.. surfaces.Select(s => s.KnotsU)]);
        var v = KnotVector.Common([.. surfaces.Select(s => s.KnotsV)]);
        return [.. surfaces.Select(s => s.Each(r => r.Snap(u).ElevateTo(u.Degree).Onto(u), r => r.Snap(v).ElevateTo(v.Degree).Onto(v)))];
    }

    /// <summary>The same surface over knots that contain its own (knot insertion, Oslo algorithm).</summary>
    /// <param name="finerU">Clamped knots of the same degree along u over the same range, or over a part, which gives that part.</param>
    /// <param name="finerV">The same along v.</param>
    /// <exception cref="GeometryException">The knots do not contain the surface's.</exception>
    public SplineSurface WithKnots(KnotVector finerU, KnotVector finerV)
    {
        ArgumentNullException.ThrowIfNull(finerU);
        ArgumentNullException.ThrowIfNull(finerV);
        return Each(r => r.Onto(finerU), r => r.Onto(finerV));
    }

    /// <summary>The same surface, clamped, with an additional knot along u.</summary>
    /// <param name="u">A parameter inside the range.</param>
    /// <param name="times">Number of insertions.</param>
    /// <exception cref="GeometryException">The parameter is not inside, or its multiplicity would exceed degree + 1.</exception>
    public SplineSurface InsertKnotU(double u, int times = 1) => WithKnots(KnotsU.Insert(u, times), KnotsV.Clamp());

    /// <summary>The same surface, clamped, with an additional knot along v.</summary>
    /// <param name="v">A parameter inside the range.</param>
    /// <param name="times">Number of insertions.</param>
    /// <exception cref="GeometryException">The parameter is not inside, or its multiplicity would exceed degree + 1.</exception>
    public SplineSurface InsertKnotV(double v, int times = 1) => WithKnots(KnotsU.Clamp(), KnotsV.Insert(v, times));

    /// <summary>The same surface, clamped, with higher degrees.</summary>
    /// <param name="degreeU">From the surface's degree along u to <see cref="KnotVector.MaxDegree"/>.</param>
    /// <param name="degreeV">The same along v.</param>
    /// <exception cref="GeometryException">A degree is out of range.</exception>
    public SplineSurface ElevateTo(int degreeU, int degreeV) => Each(r => r.ElevateTo(degreeU), r => r.ElevateTo(degreeV));

    /// <summary>The part of the surface between two pairs of parameters.</summary>
    /// <param name="fromU">First parameter along u.</param>
    /// <param name="toU">Last parameter along u.</param>
    /// <param name="fromV">First parameter along v.</param>
    /// <param name="toV">Last parameter along v.</param>
    /// <exception cref="GeometryException">The part is empty or exceeds the surface.</exception>
    public SplineSurface Between(double fromU, double toU, double fromV, double toV) =>
        WithKnots(KnotsU.Between(fromU, toU), KnotsV.Between(fromV, toV));

    /// <summary>The surface before and after a parameter u.</summary>
    /// <param name="u">A parameter inside the range.</param>
    /// <exception cref="GeometryException">The parameter is not inside.</exception>
    public (SplineSurface Before, SplineSurface After) SplitU(double u)
    {
        var v = KnotsV.Clamp();
        return (WithKnots(KnotsU.Between(KnotsU.Start, u), v), WithKnots(KnotsU.Between(u, KnotsU.End), v));
    }

    /// <summary>The surface before and after a parameter v.</summary>
    /// <param name="v">A parameter inside the range.</param>
    /// <exception cref="GeometryException">The parameter is not inside.</exception>
    public (SplineSurface Before, SplineSurface After) SplitV(double v)
    {
        var u = KnotsU.Clamp();
        return (WithKnots(u, KnotsV.Between(KnotsV.Start, v)), WithKnots(u, KnotsV.Between(v, KnotsV.End)));
    }

    /// <summary>The same surface with poles at its corners.</summary>
    public SplineSurface Clamp() => WithKnots(KnotsU.Clamp(), KnotsV.Clamp());

    /// <summary>The surface with u and v exchanged; its normal is reversed.</summary>
    public SplineSurface Swap() => new(_poles.Rows().Swap(), IsRational);

    /// <summary>The surface reversed along u; its normal is reversed.</summary>
    public SplineSurface ReverseU() => Each(r => r.Reverse(), r => r);

    /// <summary>The surface reversed along v; its normal is reversed.</summary>
    public SplineSurface ReverseV() => Each(r => r, r => r.Reverse());

    /// <summary>The same surface over other parameter ranges.</summary>
    /// <param name="startU">New first parameter along u.</param>
    /// <param name="endU">New last parameter along u, larger than the first.</param>
    /// <param name="startV">New first parameter along v.</param>
    /// <param name="endV">New last parameter along v, larger than the first.</param>
    /// <exception cref="GeometryException">A range is empty.</exception>
    public SplineSurface Reparametrize(double startU, double endU, double startV, double endV) =>
        new(KnotsU.Affine(startU, endU), KnotsV.Affine(startV, endV), Poles, Weights);

    /// <summary>The curve on the surface at a parameter u, along v.</summary>
    public SplineCurve CurveAtU(double u)
    {
        var rows = _poles.Rows();
        return SplineCurve.From(new(KnotsV, rows.AlongU().RowAt(u), rows.Size), IsRational);
    }

    /// <summary>The curve on the surface at a parameter v, along u.</summary>
    public SplineCurve CurveAtV(double v)
    {
        var rows = _poles.Rows();
        return SplineCurve.From(new(KnotsU, rows.AlongV().RowAt(v), rows.Size), IsRational);
    }

    /// <summary>The polynomial pieces, v varying fastest, each a Bezier surface over its part of the parameters.</summary>
    public IReadOnlyList<SplineSurface> Pieces() =>
        [.. from u in KnotsU.Spans() from v in KnotsV.Spans() select Piece(u, v)];

    /// <summary>A box that contains the surface: that of its poles.</summary>
    public Box3 Box() => Box3.Around(Clamp().Poles);

    /// <summary>A box that contains a range of pieces: that of the poles that affect them.</summary>
    internal Box3 Box(int firstU, int lastU, int firstV, int lastV)
    {
        var (startV, count) = (firstV - KnotsV.Degree, lastV - firstV + KnotsV.Degree + 1);
        var box = Box3.Around(Poles.Slice(((firstU - KnotsU.Degree) * CountV) + startV, count));
        for (var i = firstU - KnotsU.Degree + 1; i <= lastU; i++)
        {
            var row = Box3.Around(Poles.Slice((i * CountV) + startV, count));
            box = Box3.Around([box.Min, box.Max, row.Min, row.Max]);
        }

        return box;
    }

    /// <summary>One piece as a Bezier surface over its part of the parameters, from the poles that affect it.</summary>
    internal SplineSurface Piece(int spanU, int spanV)
    {
        var (p, q) = (KnotsU.Degree, KnotsV.Degree);
        if ((CountU, CountV) == (p + 1, q + 1))
        {
            return Clamp();
        }

        var (poles, weights) = (new List<Point3>(), new List<double>());
        for (var i = spanU - p; i <= spanU; i++)
        {
            for (var j = spanV - q; j <= spanV; j++)
            {
                poles.Add(Poles[(i * CountV) + j]);
                weights.Add(IsRational ? Weights[(i * CountV) + j] : 1);
            }
        }

        return new SplineSurface(KnotsU.OfPiece(spanU), KnotsV.OfPiece(spanV), [.. poles], [.. weights]).Clamp();
    }

    private SplineSurface Each(Func<SplineRows, SplineRows> alongU, Func<SplineRows, SplineRows> alongV) =>
        new(_poles.Rows().Each(alongU, alongV), IsRational);
}
