using Avalonia.Media;

namespace ErrorMatching.Hmi;

/// <summary>A control that draws words itself, where no control for text does: whoever looks for characters that no font has asks it.</summary>
internal interface IDrawnWords
{
    /// <summary>What it wrote last or writes when it is asked for values, with the typeface of each.</summary>
    IEnumerable<(string Words, Typeface Typeface)> DrawnWords { get; }
}
