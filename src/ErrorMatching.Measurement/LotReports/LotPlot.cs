using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Measurement;

/// <summary>Plots the pieces of a lot: what each would have shown without corrections, what was expected of it, and what was left of
/// it.</summary>
/// <param name="pieces">The pieces.</param>
/// <param name="lot">What was found at each.</param>
/// <param name="column">What a piece shows.</param>
internal sealed class LotPlot(MeasuredLot pieces, Lot lot, string column)
{
    private readonly string _column = column.ToLowerInvariant();
    private readonly PointPlot _plot = new(
        PlotAxis.Around(lot.Pieces.SelectMany((p, k) => new[]
        {
            1000 * p.ShownMm, 1000 * p.ExpectedMm, 1000 * pieces.Pieces[k].Values.ErrorsMm.Average()
        })),
        [.. lot.Pieces.Select((_, k) => Number(k))])
    {
        Size = (820, 340),
        Left = 74,
        Right = 800,
        Top = 40,
        Bottom = 290,
    };

    /// <summary>Writes the drawing.</summary>
    public void Write(HtmlText html)
    {
        var moved = lot.Pieces.Select((p, k) => (p.Event, Number: Number(k))).Where(p => p.Event != LotEvent.None).ToArray();
        var description = moved.Length == 0
            ? "Nothing out of the ordinary happened."
            : string.Join(' ', moved.Select(m => $"Piece {m.Number}: {LotSection.Word(m.Event)}."));
        using (SvgShapes.Drawing(html, "lot-plot", "plot", _plot.Size, "Mean of all points, piece by piece", description))
        {
            _plot.WriteGrid(html, Micrometres.Signed);
            _plot.WriteAxes(html, "Piece, in the order of cutting", 12, "Mean error, µm");
            for (var k = 0; k < lot.Pieces.Count; k++)
            {
                var (piece, left) = (lot.Pieces[k], pieces.Pieces[k].Values.ErrorsMm.Average());
                if (piece.Event != LotEvent.None)
                {
                    SvgShapes.Line(html, "limit", _plot.X(k), _plot.Top, _plot.X(k), _plot.Bottom);
                    SvgShapes.Text(html, "legend", _plot.X(k) + 4, _plot.Top + 12, "start", LotSection.Word(piece.Event));
                }

                var (x, shown, expected) = (_plot.X(k), piece.ShownMm, piece.ExpectedMm);
                SvgShapes.Circle(html, "before marker", x, _plot.Y(1000 * shown), 4, Title(k, "without corrections", shown));
                SvgShapes.Plus(html, "after marker", x, _plot.Y(1000 * expected), Title(k, "expected", expected));
                SvgShapes.Diamond(html, "left marker", x, _plot.Y(1000 * left), Title(k, _column, left));
            }

            SvgShapes.Circle(html, "before marker", _plot.Left + 8, 16, 4, null);
            SvgShapes.Text(html, "legend", _plot.Left + 20, 20, "start", "without corrections");
            SvgShapes.Plus(html, "after marker", _plot.Left + 218, 16, "expected of it");
            SvgShapes.Text(html, "legend", _plot.Left + 230, 20, "start", "expected of it");
            SvgShapes.Diamond(html, "left marker", _plot.Left + 428, 16, _column);
            SvgShapes.Text(html, "legend", _plot.Left + 440, 20, "start", _column);
        }
    }

    private static string Title(int piece, string what, double mm) => $"Piece {Number(piece)}, {what}: {Micrometres.SignedOfMm(mm)} µm";

    private static string Number(int piece) => (piece + 1).ToString(CultureInfo.InvariantCulture);
}
