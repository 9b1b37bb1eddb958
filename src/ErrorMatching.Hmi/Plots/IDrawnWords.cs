using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>A control that draws its own text. It reports the text, so that characters missing from every font can be found.</summary>
internal interface IDrawnWords
{
    /// <summary>The text last drawn, and the text shown on selection, each with its typeface.</summary>
    IEnumerable<(string Words, Typeface Typeface)> DrawnWords { get; }
}
