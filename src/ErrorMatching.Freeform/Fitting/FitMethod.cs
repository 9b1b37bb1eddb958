using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A method of fitting a surface to a grid: the paper's five (Lee 2019, section 2.3), and one that selects the best.</summary>
/// <remarks>A new method needs a line here, a file that implements it, and its name in <c>freeform.schema.json</c>.</remarks>
public sealed class FitMethod
{
    private FitMethod(string name, Func<PointGrid, double, FitMethod, FittedSurface> fit) => (Name, Fit) = (name, fit);

    /// <summary>The method with the lowest line-out error; finds curvature breaks.</summary>
    public static FitMethod Best { get; } = new("best", (grid, tolerance, _) => BestFit.Of(grid, tolerance));

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
