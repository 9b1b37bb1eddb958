using System.Collections;

namespace ErrorMatching.Hmi;

/// <summary>All that a frame of a path that is drawn pixel by pixel depends on; two that are equal look the same.</summary>
/// <param name="Program">The program.</param>
/// <param name="View">What is seen.</param>
/// <param name="Pixel">Size of a pixel in units of the screen.</param>
/// <param name="Chosen">Chosen blocks that are too many to be drawn as shapes; null if there are none.</param>
/// <param name="Featured">Which blocks belong to features; null if none do. The same bits for the same features.</param>
/// <param name="Rapid">Color of rapids: opacity, red, green and blue in its bytes.</param>
/// <param name="Cut">Color of cuts.</param>
/// <param name="Lit">Color of what is chosen.</param>
internal sealed record PathFrame(OpenedProgram Program, PlotView View, double Pixel, BlockRange? Chosen, BitArray? Featured, int Rapid, int Cut, int Lit)
{
    /// <summary>Width in pixels.</summary>
    public int Width => (int)Math.Ceiling(View.Width / Pixel);

    /// <summary>Height in pixels.</summary>
    public int Height => (int)Math.Ceiling(View.Height / Pixel);

    /// <summary>How a piece of the path is drawn.</summary>
    public static StrokeKind KindOf(in MoveStroke stroke, BlockRange? chosen, BitArray? featured) => chosen is { } range && range.Contains(stroke.Block) ? StrokeKind.Chosen
        : stroke.IsRapid ? StrokeKind.Rapid
        : featured?[stroke.Block] == true ? StrokeKind.Feature : StrokeKind.Cut;

    /// <summary>Draws it.</summary>
    public void Paint(PixelCanvas canvas)
    {
        var (scale, thick) = (1 / Pixel, (int)Math.Max(2, Math.Round(DrawnSizes.Thick / Pixel)));
        var colors = new[] { Rapid, Cut, Cut, Lit };
        canvas.Clear(Width, Height);
        Program.Moves.Strokes(View, Pixel, stroke =>
        {
            var kind = KindOf(stroke, Chosen, Featured);
            canvas.Line(stroke.X1 * scale, stroke.Y1 * scale, stroke.X2 * scale, stroke.Y2 * scale, colors[(int)kind], kind >= StrokeKind.Feature ? thick : 1, kind == StrokeKind.Rapid);
            return true;
        });
    }
}
