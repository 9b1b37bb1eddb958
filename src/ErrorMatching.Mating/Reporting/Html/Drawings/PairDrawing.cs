using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Part and counterpart at their seat, with exaggerated gaps and the places of contact.</summary>
/// <param name="pair">The pair.</param>
internal sealed class PairDrawing(PairAssembly pair)
{
    private const double Size = 420, Side = 56, Above = 64, Below = 60, LeastWidth = 300;

    // Places of one boundary that are further apart than this part of the outline belong to different lines.
    private const double Apart = 0.2;

    private readonly Point2 _low = new(pair.Gaps.Min(g => g.Place.X), pair.Gaps.Min(g => g.Place.Y));
    private readonly Point2 _high = new(pair.Gaps.Max(g => g.Place.X), pair.Gaps.Max(g => g.Place.Y));

    private double Diagonal => Math.Max(_low.DistanceTo(_high), 1e-6);

    private double LargestMm => pair.Gaps.Max(g => Math.Abs(g.GapMm));

    private double Factor =>
        LargestMm > 0 ? Math.Max(1, RoundNumber.AtMost(Diagonal * AssemblyScene.LargestShare / LargestMm)) : 1;

    private double PixelsPerMm => Size / Math.Max(Math.Max(_high.X - _low.X, _high.Y - _low.Y), Diagonal / 100);

    private double Width => Math.Max(LeastWidth, ((_high.X - _low.X) * PixelsPerMm) + (2 * Side));

    private double Height => ((_high.Y - _low.Y) * PixelsPerMm) + Above + Below;

    /// <summary>Writes the drawing.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    public void Write(HtmlText html, string id)
    {
        var factor = Factor;
        using (SvgShapes.Drawing(html, id, "assembly", (Width, Height), "The pair at its seat", PairWords.Of(pair)))
        {
            foreach (var line in Lines())
            {
                Outline(html, "counterpart outline", line.Select(g => g.Place));
                Outline(html, "part outline", line.Select(g => g.Place + (g.Normal * (g.GapMm * factor))));
            }

            foreach (var contact in pair.Contacts)
            {
                var (x, y) = Place(contact.Place);
                SvgShapes.Circle(html, "key-point", x, y, 4, $"{contact.Feature}, {contact.Block}");
                SvgShapes.Text(html, "tick", x + 8, y - 6, "start", SvgNumber.Label(contact.Block, 10));
            }

            Legend(html, factor);
        }
    }

    private void Legend(HtmlText html, double factor)
    {
        SvgShapes.Text(html, "drawing-title", Width / 2, 16, "middle", "The pair at its seat");
        var left = (Width - LeastWidth) / 2;
        SvgShapes.Line(html, "part outline", left + 20, 34, left + 54, 34);
        SvgShapes.Text(html, "legend", left + 61, 38, "start", "part");
        SvgShapes.Line(html, "counterpart outline", left + 140, 34, left + 174, 34);
        SvgShapes.Text(html, "legend", left + 181, 38, "start", "counterpart");
        SvgShapes.Text(
            html,
            "factor",
            left + 8,
            Height - 8,
            "start",
            factor == 1 ? "Gaps true to scale" : $"Gaps exaggerated {ReportNumber.Short(factor)} times");
    }

    // The places of a feature follow one another along its boundary.
    private IEnumerable<IReadOnlyList<PairGap>> Lines()
    {
        var line = new List<PairGap>();
        foreach (var gap in pair.Gaps)
        {
            if (line.Count > 0 && (gap.Feature != line[^1].Feature || gap.Place.DistanceTo(line[^1].Place) > Apart * Diagonal))
            {
                yield return line;
                line = [];
            }

            line.Add(gap);
        }

        yield return line;
    }

    private void Outline(HtmlText html, string cssClass, IEnumerable<Point2> places) =>
        html.Empty("polyline", ("class", cssClass), ("points", SvgNumber.Points(places.Select(Place))));

    private (double X, double Y) Place(Point2 point) => (
        ((Width - ((_high.X - _low.X) * PixelsPerMm)) / 2) + ((point.X - _low.X) * PixelsPerMm),
        Above + ((_high.Y - point.Y) * PixelsPerMm));
}
