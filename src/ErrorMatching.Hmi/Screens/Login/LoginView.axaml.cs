using System.ComponentModel;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace ErrorMatching.Hmi;

internal sealed partial class LoginView : UserControl
{
    // Below this height, the users need all the room that there is.
    private const double LowHeight = 600;

    public LoginView()
    {
        InitializeComponent();
        UserList.AddHandler(TappedEvent, OnUserTapped, RoutingStrategies.Bubble, handledEventsToo: true);

        // The second of two quick taps.
        UserList.AddHandler(DoubleTappedEvent, OnUserTapped, RoutingStrategies.Bubble, handledEventsToo: true);
    }

    /// <inheritdoc/>
    protected override void OnSizeChanged(SizeChangedEventArgs e)
    {
        ArgumentNullException.ThrowIfNull(e);
        base.OnSizeChanged(e);
        Whole.Classes.Set("near", e.NewSize.Height < LowHeight);
        Said.Classes.Set("low", e.NewSize.Height < LowHeight);
    }

    /// <inheritdoc/>
    protected override void OnLoaded(RoutedEventArgs e)
    {
        base.OnLoaded(e);
        if (DataContext is LoginViewModel login)
        {
            Later.Focus(login.Name.Length == 0 ? NameBox : PasswordBox);
            login.PropertyChanged += OnLogin;
        }
    }

    /// <inheritdoc/>
    protected override void OnUnloaded(RoutedEventArgs e)
    {
        if (DataContext is LoginViewModel login)
        {
            login.PropertyChanged -= OnLogin;
        }

        base.OnUnloaded(e);
    }

    // A tap always asks for the password, even for that of the user who is already selected.
    private void OnUserTapped(object? sender, TappedEventArgs e)
    {
        if (DataContext is LoginViewModel login && (e.Source as StyledElement)?.DataContext is UserTile user)
        {
            login.Ask(user);
            PasswordBox.Focus();
        }
    }

    // After selecting a user, continue with the password; when typing a name, stay there.
    private void OnLogin(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName is nameof(LoginViewModel.Chosen) && !NameBox.IsFocused && (sender as LoginViewModel)?.Chosen is not null)
        {
            PasswordBox.Focus();
        }
    }
}
