using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A method of fitting a surface to a grid: the paper's five (Lee 2019, section 2.3), and one that selects the best.</summary>
/// <remarks>A new method needs a line here, a file that implements it, and its name in <c>freeform.schema.json</c>.</remarks>
public sealed class FitMethod
{
    private FitMethod(string name, Func<PointGrid, double, FitMethod, FittedSurface> fit) => (Name, Fit) = (name, fit);

    /// <summary>The method with the lowest line-out error; finds curvature breaks.</summary>
    public static FitMethod Best { get; } = new("best", (grid, tolerance, _) => BestFit.Fit(grid, tolerance));

    /// <summary>A Gordon surface through both families of curves.</summary>
    public static FitMethod ThroughCurveMesh { get; } = Laid(
        "through-curve-mesh", (g, tolerance) => Same(g, CurveMeshFit.Choose(g, tolerance).Fit));

    /// <summary>Skinning: a surface through the curves along u.</summary>
    public static FitMethod ThroughCurves { get; } = Laid(
        "through-curves",
        (g, tolerance) =>
        {
            var family = CurveFamily.Choose(g.Curves, g.CurveUs, tolerance);
            return Same(g, part => SplineSurfaceFit.Skin(family.Fit(part.Curves, part.CurveUs), part.Vs));
        });

    /// <summary>Least squares on a fixed net of poles.</summary>
    public static FitMethod FitSurface { get; } = Laid("fit-surface", (g, _) => Same(g, NetFit.Fit));

    /// <summary>A fit smoothed by the bending energy of a thin plate, with the weight from cross-validation.</summary>
    public static FitMethod StudioSurface { get; } = Laid(
        "studio-surface",
        (g, _) =>
        {
            var smoothed = StudioFit.Fit(g, null);
            return (smoothed.Surface, part => StudioFit.Fit(part, smoothed.Weight).Surface);
        });

    /// <summary>Tensor-product interpolation through every point.</summary>
    public static FitMethod Tensor { get; } = Laid("tensor", (g, _) => Same(g, GridSurface.Interpolate));

    /// <summary>All methods, the selecting one first.</summary>
    public static IReadOnlyList<FitMethod> All { get; } = [Best, ThroughCurveMesh, ThroughCurves, FitSurface, StudioSurface, Tensor];

    /// <summary>The name used in files and on the console.</summary>
    public string Name { get; }

    // Arguments: the grid, the tolerance of curves in mm, and this method.
    internal Func<PointGrid, double, FitMethod, FittedSurface> Fit { get; }

    /// <summary>The method of a name; null if there is none.</summary>
    public static FitMethod? Named(string name) => All.FirstOrDefault(m => m.Name == name);

    /// <inheritdoc/>
    public override string ToString() => Name;

    // The surface, and a function that fits one to part of the points with the degree, poles or weight selected from all points.
    private static FitMethod Laid(string name, Func<FitGrid, double, (SplineSurface Surface, Func<FitGrid, SplineSurface> Again)> lay) =>
        new(
        name,
        (grid, tolerance, method) =>
        {
            var points = FitGrid.Of(grid);
            var (surface, again) = lay(points, tolerance);
            return new(method, surface, [], [], LineOutError.Mean(grid, points, g => again(FitGrid.Of(g))));
        });

    private static (SplineSurface Surface, Func<FitGrid, SplineSurface> Again) Same(FitGrid grid, Func<FitGrid, SplineSurface> lay) =>
        (lay(grid), lay);
}

/// <summary>Fit surface: least squares on the fixed net of poles of one bicubic patch.</summary>
internal static class NetFit
{
    private const int Poles = 4;

    public static SplineSurface Fit(FitGrid grid)
    {
        // The shortest curve of a ragged grid limits the poles.
        var (knotsU, knotsV) = (Knots(grid.Curves.Min(c => c.Length)), Knots(grid.Vs.Length));
        if (grid.IsRectangular)
        {
            return SplineSurfaceFit.LeastSquares(grid.ByV(), grid.Us, grid.Vs, knotsU, knotsV);
        }

        var (points, us, vs) = grid.Scattered();
        return SplineSurfaceFit.LeastSquaresScattered(points, us, vs, knotsU, knotsV);
    }

    private static KnotVector Knots(int points) => KnotVector.Clamped(Math.Min(Poles, points) - 1, [0, 1]);
}

/// <summary>Studio surface: a bicubic smoothed by the bending energy of a thin plate, with one pole per point up to a limit.</summary>
internal static class StudioFit
{
    /// <summary>Maximum number of poles along a direction. Smoothing leaves no finer detail, and time grows with the 4th power.</summary>
    private const int MostPoles = 20;

    /// <summary>The smoothed surface.</summary>
    /// <param name="grid">The points.</param>
    /// <param name="weight">Weight of the energy in mm^2; null for the one that predicts left-out points best.</param>
    public static SmoothedSurface Fit(FitGrid grid, double? weight)
    {
        var (points, us, vs) = grid.Scattered();
        // The shortest curve of a ragged grid limits the poles. Otherwise the energy alone would determine some of them.
        return SplineSurfaceFit.Smooth(
            points,
            us,
            vs,
            Knots(grid.Us, grid.Curves.Min(c => c.Length)),
            Knots(grid.Vs, grid.Vs.Length),
            grid.LengthU,
            grid.LengthV,
            weight);
    }

    // The energy determines poles that the points do not, so a cubic works for two points too.
    private static KnotVector Knots(double[] parameters, int poles) => poles < 4
        ? KnotVector.Clamped(3, [0, 1])
        : FittingKnots.ForLeastSquares(3, parameters, Math.Min(poles, MostPoles));
}
