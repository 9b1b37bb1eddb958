using Avalonia.Controls;

namespace ErrorMatching.Hmi;

/// <summary>User management.</summary>
internal sealed partial class UsersView : UserControl
{
    public UsersView() => InitializeComponent();
}
