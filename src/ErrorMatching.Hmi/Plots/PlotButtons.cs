using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Layout;
using Avalonia.Markup.Xaml.MarkupExtensions;

namespace ErrorMatching.Hmi;

/// <summary>The buttons of a plot, for those who do not zoom with fingers, wheel or keys: two by two, so that a low plot has room for them
/// and none moves when its height changes. A narrow plot has them in a column, the last one only if it has room.</summary>
internal static class PlotButtons
{
    /// <summary>Creates them, in the plot's upper right corner.</summary>
    /// <param name="nearer">Zooms in.</param>
    /// <param name="further">Zooms out.</param>
    /// <param name="all">Shows everything.</param>
    /// <param name="whole">Fills the screen with the plot, or leaves it again.</param>
    public static UniformGrid Of(Action nearer, Action further, Action all, Action whole)
    {
        var buttons = new UniformGrid
        {
            Classes = { "buttons" },
            HorizontalAlignment = HorizontalAlignment.Right,
            VerticalAlignment = VerticalAlignment.Top
        };
        buttons.Children.AddRange([
            Make("Plot.Nearer", "plus", nearer), Make("Plot.Further", "minus", further), Make("Plot.All", "all", all),
            Make("Plot.Whole", "whole", whole)]);
        buttons.Children[^1].Classes.Add("whole");
        return buttons;
    }

    /// <summary>Arranges them for the size of their plot.</summary>
    public static void Lay(UniformGrid buttons, Size plot)
    {
        buttons.Classes.Set("narrow", plot.Width < DrawnSizes.NarrowPlot);
        buttons.Classes.Remove("short");
        buttons.Measure(Size.Infinity);
        buttons.Classes.Set("short", plot.Width < DrawnSizes.NarrowPlot && buttons.DesiredSize.Height > plot.Height);
        buttons.Measure(Size.Infinity);
    }

    /// <summary>Gives them the AutomationIds that belong to their plot's.</summary>
    public static void Name(UniformGrid buttons, string? plot)
    {
        foreach (var (button, part) in buttons.Children.Zip(["nearer", "further", "all", "whole"]))
        {
            AutomationProperties.SetAutomationId(button, $"{plot}-{part}");
        }
    }

    private static Button Make(string text, string icon, Action act)
    {
        var button = new Button
        {
            Classes = { "plot" },
            Content = new Avalonia.Controls.Shapes.Path
            {
                Classes = { "icon" },
                [!Avalonia.Controls.Shapes.Path.DataProperty] = new DynamicResourceExtension("Icon." + icon)
            },
            [!AutomationProperties.NameProperty] = TextExtension.Bind(text),
        };
        button.Click += (_, _) => act();
        return button;
    }
}
