using Avalonia;
using Avalonia.Automation;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.Input;
using Avalonia.Input.TextInput;

namespace ErrorMatching.Hmi;

/// <summary>A keyboard on the screen, for gloves and for stations without another one. It types into one field, which keeps the
/// focus.</summary>
internal sealed class ScreenKeyboard : Border
{
    private readonly Dictionary<KeyboardLayout, Control> _built = [];
    private readonly List<(TextBlock Caption, BoardKey Key)> _letters = [];
    private TextBox? _field;
    private Capitals _capitals;
    private Button? _shift;

    /// <summary>An empty keyboard: its keys are made when it opens for the first time.</summary>
    public ScreenKeyboard() => Classes.Add("keyboard");

    // None, the next letter only, or all.
    private enum Capitals
    {
        None,
        Next,
        All,
    }

    /// <summary>Raised by the key that closes the keyboard.</summary>
    public event Action? Closed;

    /// <summary>True while one of its keys acts: what the field then receives comes from no other keyboard.</summary>
    public bool IsActing { get; private set; }

    /// <summary>The field that it types into; null while it is closed. A field for numbers opens digits, any other one letters.</summary>
    public TextBox? Field
    {
        get => _field;
        set
        {
            if (value == _field)
            {
                return;
            }

            _field = value;
            IsVisible = value is not null;
            if (value is not null)
            {
                Capitalize(Capitals.None);
                Show(TextInputOptions.GetContentType(value) is TextInputContentType.Number or TextInputContentType.Digits
                    or TextInputContentType.Pin ? KeyboardLayout.Numbers : KeyboardLayout.Letters);
            }
        }
    }

    private void Show(KeyboardLayout layout)
    {
        if (!_built.TryGetValue(layout, out var keys))
        {
            _built[layout] = keys = Build(layout);
        }

        Child = keys;
    }

    private StackPanel Build(KeyboardLayout layout)
    {
        var rows = new StackPanel();
        rows.Classes.AddRange(layout == KeyboardLayout.Numbers ? ["keys", "few"] : ["keys"]);
        foreach (var row in layout.Rows)
        {
            var grid = new Grid { ColumnDefinitions = [.. row.Select(k => new ColumnDefinition(k.Width, GridUnitType.Star))] };
            grid.Classes.Add("keys");
            for (var i = 0; i < row.Count; i++)
            {
                var key = KeyOf(row[i]);
                Grid.SetColumn(key, i);
                grid.Children.Add(key);
            }

            rows.Children.Add(grid);
        }

        return rows;
    }

    private Button KeyOf(BoardKey key)
    {
        // These repeat while the finger is down.
        var button = key.Act is BoardAct.Erase or BoardAct.Left or BoardAct.Right ? new RepeatButton() : new Button();
        button.Classes.Add("key");
        button.Focusable = false;
        button.Content = Caption(key);
        AutomationProperties.SetAutomationId(button, key.AutomationId);
        if (key.Act == BoardAct.Type)
        {
            AutomationProperties.SetName(button, key.Text);
        }
        else
        {
            button[!AutomationProperties.NameProperty] = (BindingBase)new TextExtension("Keyboard." + key.Act).ProvideValue(null!);
        }

        if (key.Act == BoardAct.Shift)
        {
            _shift = button;
        }

        button.Click += (_, _) => Act(key);
        return button;
    }

    private Control Caption(BoardKey key)
    {
        if (key.Act is BoardAct.Erase or BoardAct.Enter or BoardAct.Left or BoardAct.Right or BoardAct.Shift or BoardAct.Close)
        {
            var icon = new Avalonia.Controls.Shapes.Path
            {
                Data = (Avalonia.Media.Geometry)Application.Current!.FindResource("Icon.key-" + key.Act.ToString().ToLowerInvariant())!,
            };
            icon.Classes.Add("icon");
            return icon;
        }

        var caption = new TextBlock { Text = key.Text };
        if (key.Act != BoardAct.Type)
        {
            caption[!TextBlock.TextProperty] = (BindingBase)new TextExtension("Keyboard." + key.Act).ProvideValue(null!);
        }
        else if (char.IsAsciiLetter(key.Text[0]))
        {
            _letters.Add((caption, key));
        }

        return caption;
    }

    private void Act(BoardKey key)
    {
        if (_field is not { } field)
        {
            return;
        }

        IsActing = true;
        try
        {
            switch (key.Act)
            {
                case BoardAct.Type or BoardAct.Space:
                    field.RaiseEvent(
                        new TextInputEventArgs
                        {
                            RoutedEvent = TextInputEvent,
                            Source = field,
                            Text = key.Typed(_capitals != Capitals.None),
                        });
                    Capitalize(_capitals == Capitals.Next ? Capitals.None : _capitals);
                    break;
                case BoardAct.Erase:
                    Press(field, Key.Back);
                    break;
                case BoardAct.Left:
                    Press(field, Key.Left);
                    break;
                case BoardAct.Right:
                    Press(field, Key.Right);
                    break;
                case BoardAct.Enter:
                    Press(field, Key.Enter);
                    break;
                case BoardAct.Shift:
                    Capitalize((Capitals)(((int)_capitals + 1) % 3));
                    break;
                case BoardAct.Letters:
                    Show(KeyboardLayout.Letters);
                    break;
                case BoardAct.Signs:
                    Show(KeyboardLayout.Signs);
                    break;
                case BoardAct.Numbers:
                    Show(KeyboardLayout.Numbers);
                    break;
                default:
                    Closed?.Invoke();
                    break;
            }
        }
        finally
        {
            IsActing = false;
        }
    }

    private static void Press(TextBox field, Key key)
    {
        field.RaiseEvent(new KeyEventArgs { RoutedEvent = KeyDownEvent, Source = field, Key = key });
        field.RaiseEvent(new KeyEventArgs { RoutedEvent = KeyUpEvent, Source = field, Key = key });
    }

    private void Capitalize(Capitals capitals)
    {
        _capitals = capitals;
        _shift?.Classes.Set("next", capitals == Capitals.Next);
        _shift?.Classes.Set("all", capitals == Capitals.All);
        foreach (var (caption, key) in _letters)
        {
            caption.Text = key.Typed(capitals != Capitals.None);
        }
    }
}
