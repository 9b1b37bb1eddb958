using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Plans one path: the passes along edges, the passes between them, and the chains that they form.</summary>
/// <param name="context">What the path is planned with.</param>
/// <param name="decimals">Decimals of the program's coordinates.</param>
internal sealed class PathPlanning(PlanningContext context, int decimals)
{
    private readonly List<(CutPiece Piece, CenterLine Line)> _edges = [];

    public ToolPathResult Run()
    {
        if (new SurfaceFaults(context).EdgeInSurface() is { } edge)
        {
            return edge;
        }

        var (gouges, totals) = (new GougeTest(context), new PathTotals(context));
        if (context.Toolpath.ClearanceMm < context.LeastClearanceMm - 1e-9)
        {
            return TooLow(gouges.HighestPlace);
        }

        var pieces = new PieceBuilder(context, gouges);
        var chains = new ChainBuilder(context, pieces, gouges, totals);
        MakeEdges(pieces);
        if (context.Refusal is null)
        {
            MakePasses(chains, totals);
        }

        foreach (var (piece, line) in _edges)
        {
            chains.AddEdge(piece, line);
        }

        if (context.Refusal is { } refusal)
        {
            return refusal;
        }

        return new ToolPath(
            context.Builder,
            context.Offset,
            context.Rounding,
            chains.Chains,
            new(chains.Passes, totals.Points, totals.LengthMm, chains.TravelCenterZ, totals.Certificate, decimals));
    }

    private Refusal TooLow(Point3 highest)
    {
        var (clearance, least) = (context.Toolpath.ClearanceMm, StageMaterial.Text(context.LeastClearanceMm));
        var from = context.Offset.StockMm > 0 ? $" over the {StageMaterial.Text(context.Offset.StockMm)} mm that this stage leaves" : "";
        return new(
            "clearance-too-low",
            $"toolpath.clearanceMm is {PlaceText.Mm(clearance, 4)} mm. Up to {StageMaterial.Text(context.Material.Mm)} mm of material lie "
                + $"over the surface before this stage: {context.Material.Words}. Over the highest place, {PlaceText.Words(highest)}, the "
                + $"ball would travel {StageMaterial.Text(context.LeastClearanceMm - clearance)} mm too low. Write at least {least}{from}.",
            new() { Path = "$.toolpath.clearanceMm" });
    }

    // A pass along the edge of a trimmed region. Where it is nearly parallel to the passes, the area between would otherwise have none.
    private void MakeEdges(PieceBuilder pieces)
    {
        foreach (var loop in context.Offset.Surface.Region.Loops)
        {
            var line = new CenterLine();
            if (context.Refusal is null && pieces.Make([.. loop, loop[0]], line) is { } piece)
            {
                _edges.Add((piece, line));
            }
        }
    }

    // Half of the passes run on a second core. Both halves calculate the middle pass, with identical results.
    private void MakePasses(ChainBuilder chains, PathTotals totals)
    {
        var lines = new RegionLines(context.Offset.Surface);
        var middle = (lines.First + lines.Last) / 2;
        CenterLine[] edges = [.. _edges.Select(e => e.Line)];
        var (before, behind) = (new PassSeries(context.ForOtherCore(), edges), new PassSeries(context.ForOtherCore(), edges));
        var second = Task.Run(() => behind.Passes(lines, middle, lines.Last));
        var passes = before.Passes(lines, lines.First, middle);
        passes.AddRange(second.GetAwaiter().GetResult());
        foreach (var series in (PassSeries[])[before, behind])
        {
            context.Refusal ??= series.Context.Refusal;
            totals.Merge(series.Totals);
        }

        foreach (var pass in passes)
        {
            chains.Add(pass);
        }

        chains.End();
    }
}
