using Avalonia;
using Avalonia.Media;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <content>Labels and marks on the path: features with their key points, and the ends of the selection.</content>
public sealed partial class PathPlot
{
    // The feature that blocks are picked for is labeled first, so that its labels get room. Other labels that would hide the path
    // are left out.
    private void DrawLabels(DrawingContext context, PlotView view, OpenedProgram program)
    {
        var points = Picture!.Points.Where(p => view.Seen.Contains(p.At)).OrderByDescending(p => IsStrong(p.Feature)).ToArray();
        var labels = new PlotLabels(
            _strokes.Lines,
            [.. points.Select(p => view.At(p.At))],
            DrawnSizes.Dot,
            Free);
        foreach (var point in points.Where(p => IsStrong(p.Feature)))
        {
            Write(context, labels, point.Label, view.At(point.At), isStrong: true, isName: false);
        }

        foreach (var (name, at) in NamesOf(program).OrderByDescending(n => IsStrong(n.Name)))
        {
            Write(context, labels, name, view.At(at), IsStrong(name), isName: true);
        }

        foreach (var point in points.Where(p => !IsStrong(p.Feature)))
        {
            Write(context, labels, point.Label, view.At(point.At), isStrong: false, isName: false);
        }

        // Drawn last, so that no label's background covers them.
        foreach (var point in points)
        {
            Diamond(
                context,
                IsStrong(point.Feature) ? Ink : QuietBrush,
                null,
                view.At(point.At),
                IsStrong(point.Feature) ? DrawnSizes.Mark : DrawnSizes.QuietMark);
        }
    }

    // A feature's name is at the middle of its first blocks, or of its points if it has no blocks yet.
    private IEnumerable<(string Name, Point2 At)> NamesOf(OpenedProgram program)
    {
        var named = new HashSet<string>(StringComparer.Ordinal);
        foreach (var mark in Picture!.Marks)
        {
            if (mark.Ranges.Count > 0
                && program.MotionsOf(mark.Ranges[0]) is var (first, last)
                && program.Moves.EndsOf((first + last) / 2) is var (from, to))
            {
                named.Add(mark.Name);
                yield return (mark.Name, from.Lerp(to, 0.5));
            }
        }

        foreach (var feature in Picture.Points.GroupBy(p => p.Feature, StringComparer.Ordinal).Where(f => !named.Contains(f.Key)))
        {
            Point2[] places = [.. feature.Select(p => p.At)];
            yield return (feature.Key, places[(places.Length - 1) / 2].Lerp(places[places.Length / 2], 0.5));
        }
    }

    // If no feature is being picked, all are equally important.
    private bool IsStrong(string feature) => Picture!.Feature is not { } picked || picked == feature;

    private void Write(DrawingContext context, PlotLabels labels, string words, Point at, bool isStrong, bool isName)
    {
        var text = Label(words, isStrong: isName || (isStrong && Picture!.Feature is not null));
        if (!isStrong && QuietBrush is { } quiet)
        {
            text.SetForegroundBrush(quiet);
        }

        if (labels.Place(text, at, DrawnSizes.LabelAway, isName, isSpare: !isStrong && !isName) is { } room)
        {
            Words(context, text, room);
        }
    }

    private void DrawOutline(DrawingContext context, PlotView view)
    {
        var pen = new Pen(OutlineBrush, DrawnSizes.Thick, lineJoin: PenLineJoin.Bevel);
        foreach (var line in Picture!.Outline)
        {
            for (var i = 1; i < line.Count; i++)
            {
                if (view.Seen.PartOf(line[i - 1], line[i]) is var (from, to))
                {
                    context.DrawLine(pen, view.At(from), view.At(to));
                }
            }
        }
    }

    // A ring at the start of the selection, a dot at its end.
    private void DrawEnds(DrawingContext context, PlotView view, OpenedProgram program)
    {
        if (Picture!.Selection is { } range && program.MotionsOf(range) is var (first, last))
        {
            var pen = new Pen(ChosenBrush, DrawnSizes.Thick);
            if (program.Moves.EndsOf(first) is var (from, _))
            {
                context.DrawEllipse(Ground, pen, view.At(from), DrawnSizes.Ring, DrawnSizes.Ring);
            }

            if (program.Moves.EndsOf(last) is var (_, to))
            {
                context.DrawEllipse(ChosenBrush, null, view.At(to), DrawnSizes.Dot, DrawnSizes.Dot);
            }
        }
    }
}
