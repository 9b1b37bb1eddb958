using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Data;

namespace ErrorMatching.Hmi;

/// <summary>
/// The place of what is said, whose room is there before and after: what needs more room is scrolled in it, by finger, wheel or keys,
/// and moves no target.
/// </summary>
public sealed class SaidStrip : ScrollViewer
{
    // Less than this is rounding.
    private const double Least = 1;

    /// <summary>A place where nothing is said yet.</summary>
    public SaidStrip()
    {
        Classes.Add("strip");
        HorizontalScrollBarVisibility = ScrollBarVisibility.Disabled;
        this[!AutomationProperties.NameProperty] = (BindingBase)new TextExtension("Shell.Said").ProvideValue(null!);
    }

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(ScrollViewer);

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == ExtentProperty || change.Property == ViewportProperty)
        {
            // The Tab key stops only where there is something to scroll.
            Focusable = Extent.Height >= Viewport.Height + Least;
        }
    }
}
