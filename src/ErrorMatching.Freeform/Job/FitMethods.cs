namespace ErrorMatching.Freeform;

/// <summary>The names that files and the console use for the ways of fitting.</summary>
public static class FitMethods
{
    private static readonly (FitMethod Method, string Name)[] Table =
    [
        (FitMethod.Best, "best"),
        (FitMethod.ThroughCurveMesh, "through-curve-mesh"),
        (FitMethod.ThroughCurves, "through-curves"),
        (FitMethod.FitSurface, "fit-surface"),
        (FitMethod.StudioSurface, "studio-surface"),
        (FitMethod.Tensor, "tensor"),
    ];

    /// <summary>All names, the one that chooses first.</summary>
    public static IReadOnlyList<string> Names { get; } = [.. Table.Select(t => t.Name)];

    /// <summary>The method of a name; null if no method has it.</summary>
    public static FitMethod? Named(string name) => Table.Where(t => t.Name == name).Select(t => (FitMethod?)t.Method).FirstOrDefault();

    /// <summary>The name of a method.</summary>
    public static string NameOf(FitMethod method) => Table.First(t => t.Method == method).Name;
}
