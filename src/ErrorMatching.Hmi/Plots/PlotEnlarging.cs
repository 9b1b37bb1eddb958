using Avalonia;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.VisualTree;

namespace ErrorMatching.Hmi;

/// <summary>A plot that fills the screen that it is on, the outermost control of class <c>screen</c>. Whatever is beside it is hidden until
/// it leaves, but for what explains the plot (class <c>key</c>), such as a legend of its colors.</summary>
internal sealed class PlotEnlarging
{
    private readonly List<IDisposable> _covers = [];

    /// <summary>Enlarges a plot; nothing happens if it is on no screen.</summary>
    public PlotEnlarging(PlotArea plot)
    {
        if (plot.GetVisualAncestors().OfType<Control>().LastOrDefault(c => c.Classes.Contains("screen")) is not { } screen)
        {
            return;
        }

        foreach (var around in plot.GetVisualAncestors().TakeWhile(a => a != screen))
        {
            // This priority overrides all other visibility settings without changing them.
            _covers.AddRange(around.GetVisualChildren()
                .OfType<Control>()
                .Where(c => c != plot && !c.IsVisualAncestorOf(plot) && !c.Classes.Contains("key"))
                .Select(c => c.SetValue(Visual.IsVisibleProperty, false, BindingPriority.Animation))
                .OfType<IDisposable>());
        }
    }

    /// <summary>Shows everything again.</summary>
    public void Leave()
    {
        _covers.ForEach(c => c.Dispose());
        _covers.Clear();
    }
}
