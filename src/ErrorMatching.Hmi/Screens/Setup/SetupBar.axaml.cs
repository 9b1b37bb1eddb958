using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>The bar above both setup screens: edited job, undo, problems, and saving.</summary>
internal sealed partial class SetupBar : UserControl
{
    public SetupBar() => InitializeComponent();
}
