using System.Collections;

namespace ErrorMatching.Hmi;

/// <summary>Everything that a pixel-drawn frame of a path depends on. Equal frames look the same.</summary>
/// <param name="Program">The program.</param>
/// <param name="View">The visible part.</param>
/// <param name="Pixel">Size of a pixel in screen units.</param>
/// <param name="Chosen">Selected blocks, if they are too many to draw as shapes; else null.</param>
/// <param name="Featured">Which blocks belong to features; null if none do. The same instance for the same features.</param>
/// <param name="Rapid">Color of rapids, as alpha, red, green and blue bytes.</param>
/// <param name="Cut">Color of cuts.</param>
/// <param name="Lit">Color of the selection.</param>
internal sealed record PathFrame(
    OpenedProgram Program, PlotView View, double Pixel, BlockRange? Chosen, BitArray? Featured, int Rapid, int Cut, int Lit)
{
    public int Width => (int)Math.Ceiling(View.Width / Pixel);

    public int Height => (int)Math.Ceiling(View.Height / Pixel);

    public static StrokeKind KindOf(in MoveStroke stroke, BlockRange? chosen, BitArray? featured) =>
        chosen is { } range && range.Contains(stroke.Block) ? StrokeKind.Chosen
        : stroke.IsRapid ? StrokeKind.Rapid
        : featured?[stroke.Block] == true ? StrokeKind.Feature : StrokeKind.Cut;

    public void Paint(PixelCanvas canvas)
    {
        var (scale, thick) = (1 / Pixel, (int)Math.Max(2, Math.Round(DrawnSizes.Thick / Pixel)));
        var colors = new[] { Rapid, Cut, Cut, Lit };
        canvas.Clear(Width, Height);
        Program.Moves.Strokes(View, Pixel, stroke =>
        {
            var kind = KindOf(stroke, Chosen, Featured);
            canvas.Line(
                stroke.X1 * scale,
                stroke.Y1 * scale,
                stroke.X2 * scale,
                stroke.Y2 * scale,
                colors[(int)kind],
                kind >= StrokeKind.Feature ? thick : 1,
                kind == StrokeKind.Rapid);
            return true;
        });
    }
}
