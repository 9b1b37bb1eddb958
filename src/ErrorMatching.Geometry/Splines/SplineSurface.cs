using System.Runtime.Intrinsics;

namespace ErrorMatching.Geometry;

/// <summary>A tensor-product B-spline surface in space, rational if it has weights. Lengths in millimeters.</summary>
/// <remarks>Pole (i, j) has the index i * CountV + j. Parameters outside the knots continue the outermost pieces.</remarks>
public sealed partial class SplineSurface
{
    private readonly SurfacePoles _poles;

    /// <summary>Creates a surface.</summary>
    /// <param name="knotsU">Degree and knots along u.</param>
    /// <param name="knotsV">Degree and knots along v.</param>
    /// <param name="poles">Finite points, in the number that the knots require, v varying fastest.</param>
    /// <param name="weights">One positive number per pole; empty for a nonrational surface.</param>
    /// <exception cref="GeometryException">The counts do not match, a number is not finite, or a weight is not positive.</exception>
    public SplineSurface(KnotVector knotsU, KnotVector knotsV, ReadOnlySpan<Point3> poles, ReadOnlySpan<double> weights = default)
    {
        ArgumentNullException.ThrowIfNull(knotsU);
        ArgumentNullException.ThrowIfNull(knotsV);
        (KnotsU, KnotsV) = (knotsU, knotsV);
        _poles = new(knotsU, knotsV, poles, weights);
    }

    private SplineSurface(SurfaceRows rows, bool isRational)
    {
        var (poles, weights) = SplinePoles.Unflatten(rows.Values, isRational);
        (KnotsU, KnotsV) = (rows.U, rows.V);
        _poles = new(rows.U, rows.V, poles, weights);
    }

    /// <summary>Degree and knots along u.</summary>
    public KnotVector KnotsU { get; }

    /// <summary>Degree and knots along v.</summary>
    public KnotVector KnotsV { get; }

    /// <summary>Number of poles along u.</summary>
    public int CountU => KnotsU.PoleCount;

    /// <summary>Number of poles along v.</summary>
    public int CountV => KnotsV.PoleCount;

    /// <summary>The poles, v varying fastest.</summary>
    public ReadOnlySpan<Point3> Poles => _poles.Points;

    /// <summary>One weight per pole, v varying fastest; empty if the surface is not rational.</summary>
    public ReadOnlySpan<double> Weights => _poles.Weights;

    /// <summary>True if the poles have different weights.</summary>
    public bool IsRational => _poles.IsRational;

    /// <summary>The point at a pair of parameters.</summary>
    public Point3 PointAt(double u, double v) => _poles.PointAt(u, v);

    /// <summary>The point at a pair of parameters, with first and second derivatives.</summary>
    public SurfacePoint At(double u, double v) => _poles.At(u, v);

    /// <summary>Position and derivatives at a pair of parameters.</summary>
    /// <param name="u">First parameter.</param>
    /// <param name="v">Second parameter.</param>
    /// <param name="order">Highest order in each direction.</param>
    /// <param name="result">(order + 1)^2 vectors. Index a * (order + 1) + b receives the derivative of order a in u and b in v if a + b
    /// does not exceed the order. Index 0 is the position as a vector from the origin.</param>
    public void Derivatives(double u, double v, int order, Span<Vector3> result) => _poles.Derivatives(u, v, order, result);

    /// <summary>The points at every pair of parameters of two lists, v varying fastest. Evaluating along u for all poles, then along v, is
    /// faster than separately.</summary>
    /// <param name="us">Parameters along u in any order.</param>
    /// <param name="vs">Parameters along v in any order.</param>
    public Point3[] PointsAt(ReadOnlySpan<double> us, ReadOnlySpan<double> vs) => _poles.PointsAt(us, vs);

    /// <summary>The weighted line at v over one span of u, and its derivative with respect to v, in the basis functions along u.</summary>
    /// <param name="spanU">The span.</param>
    /// <param name="v">The parameter of the line.</param>
    /// <param name="rows">One row of degree + 1 factors for each number of the result.</param>
    /// <param name="place">Receives the line.</param>
    /// <param name="slope">Receives its derivative with respect to v.</param>
    internal void AlongV(int spanU, double v, ReadOnlySpan<double> rows, Span<Vector256<double>> place, Span<Vector256<double>> slope) =>
        _poles.AlongV(spanU, v, rows, place, slope);
}
