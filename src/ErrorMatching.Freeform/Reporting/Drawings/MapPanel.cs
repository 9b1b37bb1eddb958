namespace ErrorMatching.Freeform;

/// <summary>One map of a figure.</summary>
/// <param name="Title">Its title.</param>
/// <param name="Net">Places on the surface.</param>
/// <param name="ValuesUm">The values there, in micrometers.</param>
/// <param name="Points">Measured points, each with a value in micrometers.</param>
internal sealed record MapPanel(string Title, SurfaceNet Net, IReadOnlyList<double> ValuesUm, IReadOnlyList<PlottedPoint> Points)
{
    /// <summary>The values that are on the piece.</summary>
    public IEnumerable<double> Shown => Net.Outside.Count == 0 ? ValuesUm : Net.Inside().Select(k => ValuesUm[k]);
}
