using System.Globalization;

namespace ErrorMatching.Geometry;

public static partial class SplineSurfaceFit
{
    /// <summary>Skinning: the surface through curves along u, each at a parameter v, and as smooth between them as the degree allows (The
    /// NURBS Book, section 10.3).</summary>
    /// <param name="sections">At least two nonrational curves over the same parameters.</param>
    /// <param name="vs">Ascending parameters, one per curve; empty for the mean chord lengths between the curves' poles.</param>
    /// <param name="degreeV">The highest degree across the curves; lower if there are too few curves.</param>
    /// <exception cref="GeometryException">There are fewer than two curves, one is rational, their parameter ranges differ, or neighbors
    /// coincide.</exception>
    public static SplineSurface Skin(IReadOnlyList<SplineCurve> sections, ReadOnlySpan<double> vs = default, int degreeV = 3)
    {
        CheckFamily(sections);
        var curves = sections.All(s => s.Knots.Equals(sections[0].Knots)) ? sections : SplineCurve.Compatible(sections);
        var knotsU = curves[0].Knots;
        var poles = new Point3[knotsU.PoleCount * curves.Count];
        for (var j = 0; j < curves.Count; j++)
        {
            for (var i = 0; i < knotsU.PoleCount; i++)
            {
                poles[(i * curves.Count) + j] = curves[j].Poles[i];
            }
        }

        vs = vs.IsEmpty ? SplineParameters.OfGrid(poles, knotsU.PoleCount, curves.Count).V : vs;
        SplineParameters.CheckRising(vs, curves.Count);
        var knotsV = FittingKnots.ForInterpolation(Math.Min(degreeV, curves.Count - 1), vs);
        var byV = LinePass.Transposed(LinePass.Numbers(poles), knotsU.PoleCount, curves.Count);
        var alongV = LinePass.Fit(knotsV, vs, byV, 3 * knotsU.PoleCount);
        return new(knotsU, knotsV, LinePass.Points(LinePass.Transposed(alongV, knotsV.PoleCount, knotsU.PoleCount)));
    }

    /// <summary>The Gordon surface through a mesh of curves: the skin of the curves along u, plus the skin of those along v, minus the
    /// surface through their intersections (W. J. Gordon, "Spline-blended surface interpolation through curve networks", J. Math. Mech.
    /// 18, 1969; The NURBS Book, section 10.5).</summary>
    /// <param name="alongU">At least two nonrational curves along u over the same parameters; curve j is at vs[j].</param>
    /// <param name="vs">Ascending parameters of the curves along u, within the parameters of those along v.</param>
    /// <param name="alongV">At least two nonrational curves along v over the same parameters; curve i is at us[i].</param>
    /// <param name="us">Ascending parameters of the curves along v, within the parameters of those along u.</param>
    /// <param name="gapMm">Maximum distance between curves that should meet. The surface passes through both up to that gap.</param>
    /// <exception cref="GeometryException">As for <see cref="Skin"/>; or two curves that should meet are farther apart than the gap
    /// (<see cref="GeometryError.OpenMesh"/>).</exception>
    public static SplineSurface Gordon(
        IReadOnlyList<SplineCurve> alongU,
        ReadOnlySpan<double> vs,
        IReadOnlyList<SplineCurve> alongV,
        ReadOnlySpan<double> us,
        double gapMm)
    {
        CheckFamily(alongU);
        CheckFamily(alongV);
        SplineParameters.CheckRising(vs, alongU.Count);
        SplineParameters.CheckRising(us, alongV.Count);
        var meetings = new Point3[us.Length * vs.Length];
        for (var i = 0; i < us.Length; i++)
        {
            for (var j = 0; j < vs.Length; j++)
            {
                var (a, b) = (alongU[j].PointAt(us[i]), alongV[i].PointAt(vs[j]));
                var apart = (a - b).Length;
                if (!(apart <= gapMm))
                {
                    throw new GeometryException(
                        GeometryError.OpenMesh,
                        string.Create(
                            CultureInfo.InvariantCulture,
                            $"curve {j + 1} along u and curve {i + 1} along v pass each other {apart:0.#####} mm apart; at most "
                                + $"{gapMm:0.#####} mm is expected where curves of a mesh meet"));
                }

                meetings[(i * vs.Length) + j] = a + ((b - a) * 0.5);
            }
        }

        var all = SplineSurface.Compatible([Skin(alongU, vs), Skin(alongV, us).Swap(), Interpolate(meetings, us, vs)]);
        var poles = new Point3[all[0].Poles.Length];
        for (var k = 0; k < poles.Length; k++)
        {
            poles[k] = all[0].Poles[k] + (all[1].Poles[k] - all[2].Poles[k]);
        }

        return new(all[0].KnotsU, all[0].KnotsV, poles);
    }

    private static void CheckFamily(IReadOnlyList<SplineCurve> curves)
    {
        ArgumentNullException.ThrowIfNull(curves);
        if (curves.Count < 2)
        {
            throw new GeometryException(GeometryError.TooFewPoints, $"{curves.Count} curves; a surface through curves needs at least two");
        }

        if (curves.Any(c => c.IsRational))
        {
            throw new GeometryException(
                GeometryError.BadPoles, "a rational curve among those that a surface is to run through; fit it without weights first");
        }
    }
}
