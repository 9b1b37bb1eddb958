using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Plots errors along a section, as figure 6 of Lee 2019 does: the ideal surface as a straight line, what was measured above or
/// below it, the surface that is cut mirrored about it, and what is expected after.</summary>
/// <param name="section">The line.</param>
/// <param name="curves">The curves.</param>
internal sealed class SectionPlot(SurfaceSection section, IReadOnlyList<SectionCurve> curves)
{
    private const double Width = 1000, Height = 330, Left = 74, Right = 980, Top = 44, Bottom = 270;
    private const double LegendStep = 270;

    private readonly PlotAxis _axis = PlotAxis.Around(
        curves.SelectMany(c => section.Places.Where(p => p.IsInside).SelectMany(
            p => new[] { c.ValueUm(p) - c.HalfWidthUm(p), c.ValueUm(p) + c.HalfWidthUm(p) })
            .Concat(c.PointsUm.Select(p => p.ValueUm))));

    /// <summary>Writes the drawing.</summary>
    /// <param name="html">The output.</param>
    /// <param name="id">Prefix of its identifiers.</param>
    public void Write(HtmlText html, string id)
    {
        var description = string.Join(" ", curves.Select(Describe));
        using (SvgShapes.Drawing(html, id, "plot", (Width, Height), section.Words, description))
        {
            SvgShapes.Text(html, "drawing-title", Left, 16, "start", section.Words);
            WriteAxes(html);
            foreach (var curve in curves)
            {
                WriteBand(html, curve);
            }

            SvgShapes.Line(html, "zero", Left, Y(0), Right, Y(0));
            for (var k = 0; k < curves.Count; k++)
            {
                var (x, curve) = (Left + (k * LegendStep), curves[k]);
                html.Empty("path", ("class", curve.Class + " line"), ("d", Path(curve.ValueUm)));
                foreach (var (length, value, title) in curve.PointsUm)
                {
                    SvgShapes.Circle(html, curve.Class + " marker", X(length), Y(value), 3.5, title);
                }

                SvgShapes.Line(html, curve.Class + " line", x, Height - 12, x + 26, Height - 12);
                SvgShapes.Text(html, "legend", x + 32, Height - 8, "start", curve.Name);
            }
        }
    }

    private void WriteAxes(HtmlText html)
    {
        for (var tick = _axis.First; tick <= _axis.Last; tick++)
        {
            var y = Y(tick * _axis.Step);
            SvgShapes.Line(html, "grid", Left, y, Right, y);
            SvgShapes.Text(html, "tick", Left - 8, y + 4, "end", Micrometres.Signed(tick * _axis.Step));
        }

        foreach (var mm in RoundTicks.Within(0, section.LengthMm, 12))
        {
            SvgShapes.Line(html, "axis", X(mm), Bottom, X(mm), Bottom + 5);
            SvgShapes.Text(html, "tick", X(mm), Bottom + 19, "middle", ReportNumber.Short(mm));
        }

        SvgShapes.Text(html, "tick", Right - 4, Y(_axis.Highest) + 14, "end", "undercut: material is left");
        SvgShapes.Text(html, "tick", Right - 4, Y(_axis.Lowest) - 6, "end", "overcut: too much is removed");
        SvgShapes.Line(html, "axis", Left, Top - 10, Left, Bottom);
        SvgShapes.Text(html, "axis-label", (Left + Right) / 2, Bottom + 36, "middle", "Along the surface, mm");
        using (html.In(
            "text",
            ("class", "axis-label"),
            ("text-anchor", "middle"),
            ("transform", $"translate(16 {SvgNumber.Of((Top + Bottom) / 2)}) rotate(-90)")))
        {
            html.Text("Error along the normal, µm");
        }
    }

    private void WriteBand(HtmlText html, SectionCurve curve)
    {
        foreach (var run in Runs().Where(_ => curve.HasWidth))
        {
            var above = run.Select(p => (X(p.LengthMm), Y(curve.ValueUm(p) + curve.HalfWidthUm(p))));
            var below = run.Reverse().Select(p => (X(p.LengthMm), Y(curve.ValueUm(p) - curve.HalfWidthUm(p))));
            html.Empty("polygon", ("class", "section-band"), ("points", SvgNumber.Points(above.Concat(below))));
        }
    }

    private string Path(Func<SectionPlace, double> value) => string.Concat(Runs().Select(
        run => "M" + string.Join('L', run.Select(p => SvgNumber.Point(X(p.LengthMm), Y(value(p)))))));

    // The line may cross holes of a trimmed piece.
    private IEnumerable<IReadOnlyList<SectionPlace>> Runs()
    {
        var run = new List<SectionPlace>();
        foreach (var place in section.Places)
        {
            if (place.IsInside)
            {
                run.Add(place);
            }
            else if (run.Count > 0)
            {
                yield return run;
                run = [];
            }
        }

        if (run.Count > 0)
        {
            yield return run;
        }
    }

    private string Describe(SectionCurve curve)
    {
        var values = section.Places.Where(p => p.IsInside).Select(curve.ValueUm).DefaultIfEmpty().ToArray();
        return $"{curve.Name}: from {Micrometres.Signed(values.Min())} to {Micrometres.Signed(values.Max())} µm.";
    }

    private double X(double lengthMm) => Left + (lengthMm / Math.Max(section.LengthMm, 1e-9) * (Right - Left));

    private double Y(double value) => Bottom - ((value - _axis.Lowest) / (_axis.Highest - _axis.Lowest) * (Bottom - Top));
}

/// <summary>A curve of a section.</summary>
/// <param name="Name">Its legend.</param>
/// <param name="Class">Its class.</param>
/// <param name="ValueUm">Its value at a place, in micrometers.</param>
internal sealed record SectionCurve(string Name, string Class, Func<SectionPlace, double> ValueUm)
{
    /// <summary>Half the width of a band about it; zero for none.</summary>
    public Func<SectionPlace, double> HalfWidthUm { get; init; } = _ => 0;

    /// <summary>True if it has a band.</summary>
    public bool HasWidth { get; init; }

    /// <summary>Measured points, each with its position along the line, its value and a tooltip.</summary>
    public IReadOnlyList<(double LengthMm, double ValueUm, string Title)> PointsUm { get; init; } = [];
}
